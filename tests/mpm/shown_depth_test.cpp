// SPDX-License-Identifier: Apache-2.0
// The depth that rasters show of a cell: free of the particles' unevenness, and never far from the volume it holds.
#include "mpm/shown_depth.h"

#include <gtest/gtest.h>

#include <functional>

namespace frana {
namespace {

constexpr double k_cell = 25, k_filled = 1;  // [m2]; supported all round

// A layer whose particles say 2 m, with these fractions of the cells (i, j); what its volume is over the ground.
struct Layer {
    NodeGrid nodes{Raster(grid(), 0.0)};
    double volume = 0, shown = 0;

    static GridSpec grid() {
        GridSpec g;
        g.cell_size = 5;
        g.columns = g.rows = 24;
        g.north = 120;
        return g;
    }
    explicit Layer(const std::function<double(int, int)>& fraction) {
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

TEST(ShownDepth, IsTheParticlesMeanWhereTheyLieUnevenly) {
    // 6 % more or less in turn, in rows of two: no cell shows them.
    const Layer layer([](int i, int j) { return 1 + 0.06 * ((i / 2 + j) % 2 == 0 ? 1 : -1); });
    for (int j = 0; j < 24; ++j)
        for (int i = 0; i < 24; ++i) EXPECT_DOUBLE_EQ(layer.depth(i, j), 2);
}

TEST(ShownDepth, HoldsTheVolumeWhereParticlesCrowd) {
    // The same, with more than the ground has room for: a cell shows its neighbourhood's.
    for (const double mean : {1.03, 1.05, 1.2, 1.5}) {
        const Layer layer([&](int i, int j) { return mean * (1 + 0.06 * ((i / 2 + j) % 2 == 0 ? 1 : -1)); });
        EXPECT_NEAR(layer.shown, layer.volume, 0.001 * layer.volume) << mean;
        EXPECT_NEAR(layer.depth(12, 12), 2 * mean, 0.04 * mean) << mean;
    }
    // A few percent that may be unevenness are lost, at most k_lasting_from.
    for (const double mean : {1.005, 1.01, 1.015, 1.02}) {
        const Layer layer([&](int, int) { return mean; });
        EXPECT_GT(layer.shown, layer.volume / 1.0151) << mean;
        EXPECT_LT(layer.shown, layer.volume * (1 + 1e-12)) << mean;
    }
}

TEST(ShownDepth, HoldsTheVolumeOfANarrowCrowd) {
    // A gully three cells wide in which particles lie on each other, in ground that is just filled.
    const Layer layer([](int i, int) { return i >= 10 && i < 13 ? 1.4 : 1.0; });
    EXPECT_NEAR(layer.shown, layer.volume, 0.01 * layer.volume);
    EXPECT_GT(layer.depth(11, 12), 2 * 1.3);
}

TEST(ShownDepth, IsTheVolumesAtAFront) {
    EXPECT_DOUBLE_EQ(shown_depth(2 * 0.3 * k_cell, 0.3 * k_cell, 0, 1, 1 / k_cell), 0.6);
    EXPECT_EQ(shown_depth(0, 0, 0, 1, 1 / k_cell), 0);
}

TEST(MeanFraction, IsTheMeanByItsWeights) {
    NodeForces nodes[81] = {};
    for (NodeForces& node : nodes) node.area = k_cell;
    const NodeForces* const middle = nodes + 40;
    EXPECT_DOUBLE_EQ(mean_fraction<1>(middle, 9, k_cell), 1);
    EXPECT_DOUBLE_EQ(mean_fraction<2>(middle, 9, k_cell), 1);
    EXPECT_DOUBLE_EQ(mean_fraction<3>(middle, 9, k_cell), 1);
    nodes[40 + 3 * 9 - 2].area += k_cell;  // weight 1 of 64 times 6 of 64
    EXPECT_DOUBLE_EQ(mean_fraction<2>(middle, 9, k_cell), 1);
    EXPECT_DOUBLE_EQ(mean_fraction<3>(middle, 9, k_cell), 1 + 6.0 / 4096);
}

}  // namespace
}  // namespace frana
