// SPDX-License-Identifier: Apache-2.0
// The depth of a cell in rasters: independent of the particles' unevenness, and never far from its volume.
#include "mpm/shown_depth.h"

#include <gtest/gtest.h>

#include <functional>

namespace frana {
namespace {

constexpr double k_cell = 25, k_filled = 1;  // [m2]; supported on all sides

// Particles of depth 2 m with these fractions of the cells (i, j), and their volume over the area.
struct Patch {
    NodeGrid nodes{Raster(grid(), 0.0)};
    double volume = 0, shown = 0;

    static GridSpec grid() {
        GridSpec g;
        g.cell_size = 5;
        g.columns = g.rows = 24;
        g.north = 120;
        return g;
    }
    explicit Patch(const std::function<double(int, int)>& fraction) {
        nodes.phase = NodePhase::forces;
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 24; ++i) nodes.forces()[nodes.index(i, j)].area = k_cell * fraction(i, j);
        for (int j = 4; j < 20; ++j) {
            for (int i = 4; i < 20; ++i) {
                volume += 2 * fraction(i, j);
                shown += depth(i, j);
            }
        }
    }
    [[nodiscard]] double depth(int i, int j) const {
        const std::size_t n = nodes.index(i, j);
        const double area = nodes.forces()[n].area;
        return shown_depth(2 * area, area, k_filled, crowding(nodes, nodes.forces(), n, i + k_ghost, j + k_ghost),
                           1 / k_cell);
    }
};

TEST(ShownDepth, IsTheParticlesMeanForAnUnevenArrangement) {
    // Alternately 6 % more or less, in rows of two: no cell has it.
    const Patch patch([](int i, int j) { return 1 + 0.06 * ((i / 2 + j) % 2 == 0 ? 1 : -1); });
    for (int j = 0; j < 24; ++j)
        for (int i = 0; i < 24; ++i) EXPECT_DOUBLE_EQ(patch.depth(i, j), 2);
}

TEST(ShownDepth, GivesTheVolumeWhereParticlesAreCrowded) {
    // The same, with more than the available area: a cell has the value of its neighbourhood.
    for (const double mean : {1.03, 1.05, 1.2, 1.5}) {
        const Patch patch([&](int i, int j) { return mean * (1 + 0.06 * ((i / 2 + j) % 2 == 0 ? 1 : -1)); });
        EXPECT_NEAR(patch.shown, patch.volume, 0.001 * patch.volume) << mean;
        EXPECT_NEAR(patch.depth(12, 12), 2 * mean, 0.04 * mean) << mean;
    }
    // A few percent that may be unevenness are lost, at most k_lasting_from.
    for (const double mean : {1.005, 1.01, 1.015, 1.02}) {
        const Patch patch([&](int, int) { return mean; });
        EXPECT_GT(patch.shown, patch.volume / 1.0151) << mean;
        EXPECT_LT(patch.shown, patch.volume * (1 + 1e-12)) << mean;
    }
}

TEST(ShownDepth, GivesTheVolumeOfANarrowCrowd) {
    // A gully three cells wide in which particles overlap, in surroundings that are just filled.
    const Patch patch([](int i, int) { return i >= 10 && i < 13 ? 1.4 : 1.0; });
    EXPECT_NEAR(patch.shown, patch.volume, 0.01 * patch.volume);
    EXPECT_GT(patch.depth(11, 12), 2 * 1.3);
}

TEST(ShownDepth, IsTheVolumesAtAFront) {
    EXPECT_DOUBLE_EQ(shown_depth(2 * 0.3 * k_cell, 0.3 * k_cell, 0, 1, 1 / k_cell), 0.6);
    EXPECT_EQ(shown_depth(0, 0, 0, 1, 1 / k_cell), 0);
}

TEST(MeanFraction, IsTheMeanByItsWeights) {
    NodeForces nodes[81] = {};
    for (NodeForces& node : nodes) node.area = k_cell;
    const auto claim = claims_around(nodes + 40, 9);
    EXPECT_DOUBLE_EQ((mean_fraction<1, double>(claim, k_cell)), 1);
    EXPECT_DOUBLE_EQ((mean_fraction<2, double>(claim, k_cell)), 1);
    EXPECT_DOUBLE_EQ((mean_fraction<3, double>(claim, k_cell)), 1);
    nodes[40 + 3 * 9 - 2].area += k_cell;  // weight 1 of 64 times 6 of 64
    EXPECT_DOUBLE_EQ((mean_fraction<2, double>(claim, k_cell)), 1);
    EXPECT_DOUBLE_EQ((mean_fraction<3, double>(claim, k_cell)), 1 + 6.0 / 4096);
}

}  // namespace
}  // namespace frana
