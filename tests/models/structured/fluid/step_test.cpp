// SPDX-License-Identifier: Apache-2.0
// What must hold in every step: mass, positive depth, the same bits for any number of threads, cost by wet
// cells.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "basin.h"

namespace frana::structured::test {
namespace {

using bench::plain_grid;
using bench::sample_raster;

Raster hills(std::int64_t cells) {
    return sample_raster(plain_grid(cells, cells, 2),
                         [](Point p) { return 8 * std::sin(p.x / 11) * std::cos(p.y / 9) - 0.3 * p.x; });
}

Water drop(Point p) {
    const double r2 = (p.x - 80) * (p.x - 80) + (p.y - 80) * (p.y - 80);
    return {std::max(0.0, 6 - r2 / 60)};
}

FluidLaws rough_laws() {
    FluidLaws laws = still_laws();
    laws.steep = true;
    laws.manning = 0.04;
    laws.viscosity = 5;
    return laws;
}

// A film under the dry depth does not move; what came as one is counted all the same, however long it lies.
TEST(FluidStep, AFilmThatWasNeverWetIsCounted) {
    Basin basin(hills(80), rough_laws());
    basin.fill([&](Point p) { return Water{p.x < 20 && p.y < 20 ? 0.5 * basin.laws.dry : 0}; });
    const double volume = basin.volume();
    EXPECT_GT(volume, 0);
    for (int i = 0; i < 3; ++i) basin.advance(1);
    EXPECT_EQ(basin.volume(), volume);
}

TEST(FluidStep, WhatFlowsIntoGapsIsCounted) {
    Raster ground = hills(80);
    for (std::int64_t row = 0; row < 80; ++row) ground.at(row, 55) = k_no_data;
    Basin basin(ground, rough_laws());
    basin.fill(drop);
    const double volume = basin.volume();
    basin.advance(30);
    EXPECT_GT(basin.state.volume_into_gaps, 0);
    EXPECT_NEAR(basin.volume() + basin.state.now.volume_left, volume, 1e-12 * volume);
}

// The four quarters of a square basin mirror each other to rounding. What x and y differ by is the error of sweeps in
// turn, of second order (Strang 1968, SIAM J. Numer. Anal. 5, 506): a quarter with half the cells.
TEST(FluidStep, KeepsSymmetry) {
    const auto turned = [](std::int64_t side) {
        const double cell = 60.0 / static_cast<double>(side);
        Basin basin(Raster(plain_grid(side, side, cell), 0.0), still_laws());
        basin.fill([](Point p) {
            return Water{0.5 + 0.5 * std::exp(-((p.x - 30) * (p.x - 30) + (p.y - 30) * (p.y - 30)) / 40)};
        });
        basin.advance(5);
        double difference = 0;
        for (std::int64_t j = 0; j < side; ++j) {
            for (std::int64_t i = 0; i < side; ++i) {
                EXPECT_NEAR(basin.depth(i, j), basin.depth(side - 1 - i, j), 1e-12);
                EXPECT_NEAR(basin.depth(i, j), basin.depth(i, side - 1 - j), 1e-12);
                difference += std::abs(basin.depth(i, j) - basin.depth(j, i)) * cell * cell;
            }
        }
        return difference;
    };
    const double coarse = turned(60), fine = turned(120);
    EXPECT_LT(fine, 0.3 * coarse);
}

TEST(FluidStep, WorkFollowsTheWetCells) {
    Basin small(Raster(plain_grid(64, 64, 1), 0.0), still_laws());
    Basin large(Raster(plain_grid(1024, 1024, 1), 0.0), still_laws());
    for (Basin* basin : {&small, &large})
        basin->fill([](Point p) { return Water{std::hypot(p.x - 32, p.y - 32) < 5 ? 1.0 : 0.0}; });
    const FluidReport a = small.advance(1), b = large.advance(1);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_LE(b.updated_cells, a.updated_cells * 2);
    EXPECT_LT(b.updated_cells, b.steps * 1024 * 1024 / 100);
}

// A wall with a gap: nothing behind it but what came through.
TEST(FluidStep, WallsHold) {
    Raster walls(plain_grid(40, 40, 1), 0);
    for (std::int64_t row = 0; row < 40; ++row) walls.at(row, 20) = 1;
    Basin closed(Raster(walls.grid, 0.0), still_laws(), 1, &walls);
    closed.fill([](Point p) { return Water{p.x < 20 ? 1.0 : 0.0, 3, 0}; });
    closed.advance(10);
    double behind = 0;
    closed.for_cells([&](Point p, std::size_t cell) { behind += p.x > 20 ? closed.state.now.depth[cell] : 0; });
    EXPECT_EQ(behind, 0);

    walls.at(20, 20) = 0;
    Basin open(Raster(walls.grid, 0.0), still_laws(), 1, &walls);
    open.fill([](Point p) { return Water{p.x < 20 ? 1.0 : 0.0}; });
    open.advance(10);
    open.for_cells([&](Point p, std::size_t cell) { behind += p.x > 21 ? open.state.now.depth[cell] : 0; });
    EXPECT_GT(behind, 1);
}

TEST(FluidStep, ReceivesVolumeAndMomentumAsTheyAre) {
    Basin basin(Raster(plain_grid(10, 10, 1), 0.0), still_laws());
    const std::size_t cell = basin.nodes.index(4, 5);
    const std::vector<FluidSource> sources{{cell, 0.3, 0.6, -0.1}, {cell, 0.2, 0.1, 0}};
    EXPECT_EQ(receive(sources, basin.state, basin.laws), 0);
    EXPECT_EQ(basin.state.now.depth[cell], 0.5);
    EXPECT_EQ(basin.state.now.qx[cell], 0.7);
    EXPECT_EQ(basin.state.now.qy[cell], -0.1);
    EXPECT_EQ(basin.volume(), 0.5);
    const std::vector<FluidSource> outside{{basin.nodes.index(-1, 0), 0.25, 0, 0}};
    EXPECT_EQ(receive(outside, basin.state, basin.laws), 0.25);
}

// No depth becomes negative and no step hangs where cells run empty over sharp steps.
TEST(FluidStep, RandomStepsAndDropsStayPositive) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    const Raster ground = sample_raster(plain_grid(40, 40, 1), [&](Point) { return 5 * unit(random); });
    Basin basin(ground, still_laws());
    basin.fill([&](Point) { return Water{unit(random) < 0.3 ? 3 * unit(random) : 0.0, 20 * unit(random) - 10, 0}; });
    const double volume = basin.volume();
    const FluidReport report = basin.advance(5);
    EXPECT_EQ(report.non_finite, 0);
    EXPECT_NEAR(basin.volume(), volume, 1e-12 * volume);
}

TEST(FluidStep, AnUndefinedStateEndsTheRun) {
    Basin basin(Raster(plain_grid(10, 10, 1), 0.0), still_laws());
    basin.fill([](Point) { return Water{1}; });
    basin.state.now.qx[basin.nodes.index(5, 5)] = k_no_data;
    EXPECT_GT(basin.advance(1).non_finite, 0);
}

// A speed that allows no step of any length to speak of ends the advance; it must not go on for ever.
TEST(FluidStep, ASpeedNextToInfiniteIsCountedAndEndsTheStep) {
    for (const double speed : {1e12, 1e150, std::numeric_limits<double>::infinity()}) {
        Basin basin(hills(40), rough_laws());
        basin.fill([&](Point p) { return Water{1, p.x < 4 && p.y < 4 ? speed : 0}; });
        const FluidReport report = basin.advance(1);
        EXPECT_GT(report.non_finite, 0) << speed;
        EXPECT_EQ(report.steps, 0) << speed;
    }
}

}  // namespace
}  // namespace frana::structured::test
