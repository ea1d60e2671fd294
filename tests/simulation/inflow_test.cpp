// SPDX-License-Identifier: Apache-2.0
// Inflow through a line: the hydrograph's volume up to rounding, and the uniform flow given by discharge and slope.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/set_up/setup.h"
#include "core/error.h"
#include "physics/laws.h"
#include "simulation/arrivals.h"
#include "simulation/simulation.h"
#include "support/problems.h"

namespace frana {
namespace {

double sum_of(const std::vector<InflowBatch>& rows) {
    double sum = 0;
    for (const InflowBatch& row : rows) sum += row.volume;
    return sum;
}

TEST(CutHydrograph, ConservesTheVolumeUntilTheEnd) {
    const std::vector<HydrographPoint> triangle{{0, 0, 0}, {100, 10, 4}, {300, 0, 0}};
    const auto rows = cut_hydrograph(triangle, 2.5, 1000);
    EXPECT_NEAR(sum_of(rows), 1500, 1e-12 * 1500);
    for (const InflowBatch& row : rows) {
        EXPECT_LE(row.length, 2.5 * (1 + 1e-12));
        // Q / v is 2.5 m2 at every time, and so is every row's section.
        EXPECT_NEAR(row.volume / row.length, 2.5, 1e-9);
    }
    // Trapezoidal sums by hand: 500 m3 until 100 s, then (10 + 7.5) / 2 x 50 m3.
    const auto cut = cut_hydrograph(triangle, 2.5, 150);
    EXPECT_NEAR(sum_of(cut), 937.5, 1e-12 * 937.5);
    EXPECT_EQ(cut.back().time, 150);
    Inflow inflow;
    inflow.hydrograph = triangle;
    EXPECT_EQ(volume_of(inflow, 1000), 1500);
    EXPECT_EQ(volume_of(inflow, 150), 937.5);
    EXPECT_EQ(volume_of(inflow, 0), 0);
    inflow.hydrograph = {{0, 3, 2}, {10, 3, 2}, {10, 5, 2}, {20, 5, 2}};  // a step
    EXPECT_EQ(volume_of(inflow, 15), 30 + 25);
}

// A row that is full exactly where the hydrograph bends ends there, and the next begins.
TEST(CutHydrograph, RowsMayEndWhereTheHydrographBends) {
    const std::vector<HydrographPoint> trapezium{{0, 0, 2}, {1, 20, 2}, {4, 20, 2}, {5, 0, 2}};
    const auto rows = cut_hydrograph(trapezium, 1, 100);
    EXPECT_NEAR(sum_of(rows), 80, 1e-12 * 80);
    EXPECT_EQ(rows.size(), 10u);  // 10 m in 5 s
}

TEST(CutHydrograph, DelaysNothingOverAPause) {
    const std::vector<HydrographPoint> waves{{0, 2, 1}, {7, 2, 1}, {7, 0, 1}, {500, 0, 1}, {500, 3, 1}, {510, 3, 1}};
    const auto rows = cut_hydrograph(waves, 2, 1000);
    double first = 0;
    for (const InflowBatch& row : rows) {
        if (row.time > 7) continue;
        first += row.volume;
    }
    EXPECT_NEAR(first, 14, 1e-12 * 14);
    EXPECT_NEAR(sum_of(rows), 44, 1e-12 * 44);
}

// A channel 20 m wide falling 1 in 10 to the east, walls on all sides.
Scene channel_scene() {
    Scene scene;
    scene.grid = {600000, 5000020, 2, 150, 10, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r)
        for (std::int64_t c = 0; c < scene.grid.columns; ++c)
            scene.terrain.at(r, c) = 100 - 0.1 * scene.grid.cell_size * static_cast<double>(c);
    scene.material.of<CoulombFriction>().friction_coefficient = 0.02;
    scene.material.of<TurbulentFriction>().turbulence = 500;
    scene.numerics.slope_correction = SlopeCorrection::none;
    scene.numerics.boundary = Boundary::wall;
    scene.time.end = 20;
    return scene;
}

// Steady uniform flow on a plane: v^2 = xi h (S - mu). One metre deep: v = sqrt(500 x 0.08) = 6.32 m/s, twice the
// critical speed, so that the inflow determines it.
TEST(Inflow, GivesTheUniformFlowOfItsDischarge) {
    Scene scene = channel_scene();
    const double speed = std::sqrt(500 * 0.08), discharge = speed * 20;
    scene.inflows = {{{{600010, 5000000}, {600010, 5000020}}, {{0, discharge, speed}, {60, discharge, speed}}, {}}};
    scene.time.frame_interval = 20;
    RunOptions options;
    Raster velocity;
    options.on_frame = [&](const Frame& frame) { velocity = frame.velocity; };  // the last one is kept
    const RunResult result = run(scene, options);
    EXPECT_NEAR(result.volume_inflow, discharge * 20, 1e-12 * discharge * 20);
    EXPECT_NEAR(result.volume_final + result.volume_left, result.volume_entered, 1e-12 * result.volume_entered);
    EXPECT_TRUE(result.hard_events.none());
    // From 42 m to 80 m, where the front passed long ago and the disturbance behind the line, a few cells long, has
    // decayed: one per cent. Without the rows' pressure it would be six.
    for (std::int64_t c = 21; c < 40; ++c) {
        for (std::int64_t r = 1; r < 9; ++r) {
            EXPECT_NEAR(result.raster("final_depth").at(r, c), 1, 0.01) << "column " << c;
            EXPECT_NEAR(velocity.at(r, c), speed, 0.01 * speed) << "column " << c;
        }
    }
    // The front of a supercritical uniform flow moves near its speed: neither delayed at the line nor ejected.
    EXPECT_NEAR(result.series.back().front_distance, speed * 20, 0.25 * speed * 20);
}

TEST(Inflow, IsInTheBudgetWithWhatFailsLater) {
    Scene scene = channel_scene();
    scene.time.end = 8;
    scene.inflows = {{{{600010, 5000004}, {600010, 5000016}}, {{0, 0, 0}, {3, 90, 5}, {6, 0, 0}}, {}}};
    scene.release = {{{{{{600050, 5000004}, {600070, 5000004}, {600070, 5000016}, {600050, 5000016}}, {}}}, 1}};
    scene.release[0].start = 2.5;
    const RunResult one = run(scene, {});
    EXPECT_LT(one.thin_fraction, 0.1) << "the first drops are not the flow";
    EXPECT_NEAR(one.volume_entered, 0.5 * 90 * 6 + 20 * 12, 1e-12 * one.volume_entered);
    EXPECT_TRUE(one.released[0].failed);
    // Material that failed and flowed in later is part of the budget: relative to the initial volume the error would be
    // 100 %.
    EXPECT_EQ(one.volume_initial, 0);
    EXPECT_LT(relative_volume_error(one), 1e-11);
    for (const SeriesRow& row : one.series)
        EXPECT_NEAR(row.volume + row.volume_left, row.volume_entered, 1e-11 * one.volume_entered) << row.time;
}

TEST(Inflow, RefusesAnUnusableLine) {
    Scene scene = channel_scene();
    const std::vector<HydrographPoint> hydrograph{{0, 10, 2}, {60, 10, 2}};
    const auto refused = [&](const Polyline& line, std::optional<double> azimuth) {
        scene.inflows = {{line, hydrograph, azimuth}};
        try {
            run(scene, {});
        } catch (const Error& error) {
            return error.problems();
        }
        return std::vector<Problem>();
    };
    const Polyline across{{600010, 5000004}, {600010, 5000016}};
    EXPECT_TRUE(
        has_problem(refused({{600010, 4999990}, {600010, 5000016}}, {}), "inflow.line", "(600010.0, 4999990.5)"));
    EXPECT_TRUE(has_problem(refused(across, 0), "inflow.direction"));
    const auto level = refused({{600010, 5000010}, {600040, 5000010}}, {});
    EXPECT_TRUE(has_problem(level, "inflow.line"));
    EXPECT_NE(level.front().remedy.find("inflow.direction"), std::string::npos) << level.front().remedy;
    scene.terrain.at(5, 5) = k_no_data;
    EXPECT_TRUE(has_problem(refused(across, {}), "inflow.line", "(600010.0, 5000008.5)"));
}

}  // namespace
}  // namespace frana
