// SPDX-License-Identifier: Apache-2.0
// Where the tail of a flow is: behind a wave on a slope, but not at a shore, at the wave, or beside dry ground.
#include "models/voellmy_bingham/tail.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "bench/set_up/setup.h"

namespace frana::voellmy_bingham {
namespace {

constexpr std::int64_t k_cells = 12;
constexpr double k_dx = 5;
constexpr double k_deepest = 2;

// Marks of filled cells with this depth on a plane that falls along x and y; so far it was `deepest` everywhere.
struct Marks {
    NodeGrid nodes;
    std::vector<std::uint8_t> tail;

    Marks(double slope_x, double slope_y, const std::function<double(Point)>& depth, double deepest = k_deepest)
        : nodes(bench::sample_raster(bench::plain_grid(k_cells, k_cells, k_dx),
                                     [&](Point p) { return -slope_x * p.x - slope_y * p.y; })),
          tail(nodes.size()) {
        nodes.phase = NodePhase::motion;
        for (std::int64_t j = 0; j < k_cells; ++j) {
            for (std::int64_t i = 0; i < k_cells; ++i) {
                NodeMotion& node = nodes.motion()[nodes.index(i, j)];
                node.mass = k_dx * k_dx * depth(nodes.middle(i + k_ghost, j + k_ghost));
                node.fraction = node.mass > 0 ? 1 : 0;
            }
        }
        const std::vector<double> depths(nodes.size(), deepest);
        const TileGrid tiles{nodes.columns(), nodes.rows(), k_ghost, k_dx};
        for (std::int64_t t = 0; t < tiles.tiles_x() * tiles.tiles_y(); ++t)
            mark_tail(NodeRange(t, tiles, nodes), nodes, depths.data(), tail.data());
    }
    [[nodiscard]] int at(std::int64_t i, std::int64_t j) const { return tail[nodes.index(i, j)]; }
};

TEST(Tail, IsWhatIsLeftOfAWaveOnASlope) {
    for (const double factor : {0.9, 1.1}) {
        const double depth = factor * k_tail_depth * k_deepest;
        const Marks marks(0.3, 0.2, [&](Point) { return depth; });
        EXPECT_EQ(marks.at(6, 6), factor < 1 ? 1 : 0);
    }
}

TEST(Tail, IsNotWhereTheDepthVariesAsTheBedFalls) {
    // Over a cell the bed falls by 1.5 m and the depth grows by a tenth below or above a quarter of that.
    for (const double factor : {0.9, 1.1}) {
        const double growth = factor * 0.3 / k_tail_fall;
        const auto depth = [&](double way) { return 0.3 + growth * (way - 6.5 * k_dx); };
        const Marks along_x(0.3, 0, [&](Point p) { return depth(p.x); });
        const Marks along_y(0, 0.3, [&](Point p) { return depth(p.y); });
        EXPECT_EQ(along_x.at(6, 6), factor < 1 ? 1 : 0);
        EXPECT_EQ(along_y.at(6, 6), factor < 1 ? 1 : 0);
    }
}

TEST(Tail, IsNotTheShoreOfAPoolNorALevelFilm) {
    // A level pool on a slope of 0.3, and a film on level ground.
    const Marks pool(
        0.3, 0, [](Point p) { return 0.3 * p.x; }, 100);
    const Marks film(0, 0, [](Point) { return 0.3; });
    for (std::int64_t i = 1; i < k_cells - 1; ++i) {
        EXPECT_EQ(pool.at(i, 6), 0) << i;
        EXPECT_EQ(film.at(i, 6), 0) << i;
    }
}

}  // namespace
}  // namespace frana::voellmy_bingham
