// SPDX-License-Identifier: Apache-2.0
// The state held on the grid: a difference on a level bed, nothing where it would not be the flow's own.
#include "mpm/held_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "bench/set_up/setup.h"

namespace frana {
namespace {

constexpr std::int64_t k_cells = 40;
constexpr double k_dx = 2, k_gravity = 9.81;

// Nodes that are filled by water of a depth over a bed, as thin flow or, ponding, as a pool; with walls all round.
struct Water {
    NodeGrid nodes;

    Water(const std::function<double(Point)>& bed, const std::function<double(Point)>& depth, double ponding)
        : nodes(bench::sample_raster(bench::plain_grid(k_cells, k_cells, k_dx), bed)) {
        nodes.allocate_levels();
        nodes.phase = NodePhase::forces;
        for (std::int64_t j = -k_ghost; j < k_cells + k_ghost; ++j) {
            for (std::int64_t i = -k_ghost; i < k_cells + k_ghost; ++i) {
                const std::size_t n = nodes.index(i, j);
                const Point p = nodes.middle(i + k_ghost, j + k_ghost);
                NodeForces& node = nodes.forces()[n];
                node.mass = node.area = k_dx * k_dx;
                node.crowding = 1;
                nodes.levels[n] = {depth(p), depth(p) + nodes.bed[n], ponding, 1, depth(p), 0};
            }
        }
    }
    void hold() {
        const TileGrid tiles{nodes.columns(), nodes.rows(), k_ghost, k_dx};
        for (std::int64_t t = 0; t < tiles.tiles_x() * tiles.tiles_y(); ++t)
            hold_on_grid(NodeRange(t, tiles, nodes), k_gravity, true, nodes);
    }
    [[nodiscard]] double share(std::int64_t i, std::int64_t j) const { return nodes.levels[nodes.index(i, j)].share; }
    [[nodiscard]] const NodeForces& force(std::int64_t i, std::int64_t j) const {
        return nodes.forces()[nodes.index(i, j)];
    }
};

TEST(HeldState, ForcesOnALevelBedAreThoseAtTheWalls) {
    // With level water at the walls, however rough between.
    const auto depth = [](Point p) {
        const double x = p.x - 40, y = p.y - 40;
        return 5 + 3 * std::exp(-(x * x + y * y) / 30) * (1 + 0.3 * std::sin(3 * p.x + 5 * p.y)) * (x < 0 ? 1 : 0.4);
    };
    Water water([](Point) { return 0; }, depth, 0);
    for (std::int64_t i = 0; i < k_cells; ++i) {
        double& east = water.nodes.levels[water.nodes.index(i, 20)].held;
        east *= 1 + 0.2 * (i > 15 && i < 25);
    }
    water.hold();
    double x = 0, y = 0, largest = 0;
    for (std::int64_t j = 0; j < k_cells; ++j) {
        for (std::int64_t i = 0; i < k_cells; ++i) {
            EXPECT_EQ(water.share(i, j), 1);
            x += water.force(i, j).fx;
            y += water.force(i, j).fy;
            largest = std::max(largest, std::abs(water.force(i, j).fx));
        }
    }
    EXPECT_GT(largest, 10);
    EXPECT_NEAR(x, 0, 1e-10);
    EXPECT_NEAR(y, 0, 1e-10);
}

TEST(HeldState, IsOfSecondOrder) {
    // Against -g h dh/dx dx^2; the squares of the surface's differences are an error of second order by themselves.
    double error[2];
    for (const int halved : {0, 1}) {
        const double length = halved ? 160 : 80, k = 2 * 3.14159265358979 / length;
        Water water([](Point) { return 0; }, [&](Point p) { return 5 + std::sin(k * p.x); }, 0);
        water.hold();
        error[halved] = 0;
        for (std::int64_t i = 4; i < k_cells - 4; ++i) {
            const double at = k * water.nodes.middle(i + k_ghost, 0).x;
            const double exact = -k_gravity * k_dx * k_dx * (5 + std::sin(at)) * k * std::cos(at);
            error[halved] = std::max(error[halved], std::abs(water.force(i, 20).fx - exact) / k);
        }
    }
    EXPECT_GT(error[0], 1e-3);
    EXPECT_LT(error[1], 0.27 * error[0]);
}

TEST(HeldState, HasNoShareWhereItIsNotTheFlowsOwn) {
    const auto depth = [](Point) { return 2.0; };
    Water steep([](Point p) { return 0.5 * p.x; }, depth, 0);
    steep.hold();
    Water water([](Point) { return 0; }, depth, 0);
    water.nodes.forces()[water.nodes.index(20, 20)].area *= 0.5;   // a front
    water.nodes.forces()[water.nodes.index(30, 10)].crowding = 2;  // a pile
    water.hold();
    for (std::int64_t j = 0; j < k_cells; ++j) {
        for (std::int64_t i = 0; i < k_cells; ++i) {
            EXPECT_EQ(steep.share(i, j), 0);
            const std::int64_t a = std::abs(i - 20), b = std::abs(j - 20);
            const bool front = (a <= 1 && b <= 1) || (a <= 2 && b == 0) || (a == 0 && b <= 2);
            EXPECT_EQ(water.share(i, j), front || (i == 30 && j == 10) ? 0 : 1) << i << ", " << j;
        }
    }
}

// A film of a fiftieth of the depth beside it: otherwise the hard case wave-over-film reaches seven times the greatest
// possible speed.
TEST(HeldState, HasNoShareBetweenDeepWaterAndAFilm) {
    for (const double least : {0.04, 0.2}) {
        Water water([](Point) { return 0; }, [&](Point p) { return p.x < 20 * k_dx ? 2 : least; }, 0);
        water.hold();
        for (std::int64_t i = 0; i < k_cells; ++i)
            EXPECT_EQ(water.share(i, 20), least < 0.1 && i >= 18 && i < 22 ? 0 : 1) << i << ", " << least;
    }
}

}  // namespace
}  // namespace frana
