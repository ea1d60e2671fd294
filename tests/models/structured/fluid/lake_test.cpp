// SPDX-License-Identifier: Apache-2.0
// U18: a lake at rest stays at rest, whatever lies under it.
#include <gtest/gtest.h>

#include <random>

#include "basin.h"

namespace frana::structured::test {
namespace {

using bench::plain_grid;
using bench::sample_raster;

constexpr double k_level = 10;

// Random ground between 4 and 9 m, with an island that rises to 13 m.
Raster rough_ground() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> height(4, 9);
    return sample_raster(plain_grid(60, 50, 2), [&](Point p) {
        const double r2 = (p.x - 70) * (p.x - 70) + (p.y - 40) * (p.y - 40);
        return height(random) + 9 * std::exp(-r2 / 300);
    });
}

void stays_at_rest(Basin& basin) {
    int emerged = 0, drowned = 0;
    std::vector<FluidSource> sources;
    basin.for_cells([&](Point, std::size_t cell) {
        if (!basin.has_fluid(cell)) return;
        const double ground = basin.nodes.bed[cell] + basin.nodes.datum();
        if (ground < k_level) {
            sources.push_back({cell, k_level - ground});
            ++drowned;
        } else {
            ++emerged;
        }
    });
    receive(sources, basin.state, basin.laws);
    ASSERT_GT(emerged, 20);
    ASSERT_GT(drowned, 500);
    const double volume = basin.volume();
    for (int i = 0; i < 4; ++i) {
        basin.advance(5);
        EXPECT_LT(basin.greatest_speed(), 1e-10) << "after " << 5 * (i + 1) << " s";
    }
    EXPECT_NEAR(basin.volume(), volume, 1e-12 * volume);
}

TEST(FluidLake, RestsOnRandomGroundRoundAnIsland) {
    Basin basin(rough_ground(), still_laws());
    stays_at_rest(basin);
}

TEST(FluidLake, RestsWhereSlopesAreSteep) {
    FluidLaws laws = still_laws();
    laws.steep = true;
    Basin basin(rough_ground(), laws);
    stays_at_rest(basin);
}

TEST(FluidLake, RestsAtOpenEdges) {
    FluidLaws laws = still_laws();
    laws.wall = false;
    Basin basin(rough_ground(), laws);
    stays_at_rest(basin);
    EXPECT_EQ(basin.state.now.volume_left, 0);
}

TEST(FluidLake, RestsAgainstWallsAndGaps) {
    Raster ground = rough_ground();
    for (std::int64_t row = 20; row < 26; ++row) ground.at(row, 10) = k_no_data;
    Raster walls(ground.grid, 0);
    for (std::int64_t column = 15; column < 40; ++column) walls.at(10, column) = 1;
    FluidLaws laws = still_laws();
    laws.gaps_are_open = false;
    Basin basin(ground, laws, 1, &walls);
    stays_at_rest(basin);
}

// Water against a step of the bed whose speed has died away to less than a number's least inverse.
TEST(FluidLake, SpeedsThatHaveDiedAwayStayNumbers) {
    Basin basin(sample_raster(plain_grid(20, 20, 1), [](Point p) { return p.x < 10 ? 0.0 : 5.0; }), still_laws());
    basin.fill([](Point p) { return Water{p.x < 10 ? 1.0 : 0.0, 1e-310, 0}; });
    basin.advance(0.1);
    EXPECT_EQ(basin.volume(), 200);
}

}  // namespace
}  // namespace frana::structured::test
