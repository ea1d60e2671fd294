// SPDX-License-Identifier: Apache-2.0
// The structured model through a scene: fluid alone, and solids with their fluid.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/simulation.h"

namespace frana {
namespace {

// 2 m on a slope that runs out on the flat.
Scene slope(bool solids) {
    Scene scene;
    scene.grid = {600000, 5000120, 2, 120, 60, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < 60; ++r) {
        for (std::int64_t c = 0; c < 120; ++c)
            scene.terrain.at(r, c) = 100 + std::max(0.0, 0.5 * (120 - 2.0 * static_cast<double>(c)));
    }
    scene.release = {
        {{{{{600030, 5000040}, {600060, 5000040}, {600060, 5000080}, {600030, 5000080}}, {}}}, 2, {}, {}, false}};
    scene.structured = StructuredMaterial{};
    scene.structured->manning = 0.05;
    scene.structured->solids = solids;
    if (solids) {
        scene.structured->cohesion = 2e3;
        scene.structured->friction = std::tan(28 * M_PI / 180);
        scene.structured->bed_friction = std::tan(15 * M_PI / 180);
        scene.structured->young_modulus = scene.structured->bulk_modulus = 2e5;
        scene.numerics.particles_per_cell = 9;
    }
    scene.time.end = solids ? 2 : 20;
    scene.time.frame_interval = 1;
    return scene;
}

constexpr double k_released = 2 * 30 * 40;

void budget_closes(const RunResult& result) {
    EXPECT_TRUE(result.hard_events.none());
    EXPECT_NEAR(result.volume_initial, k_released, 1e-9 * k_released);
    EXPECT_LT(relative_volume_error(result), 1e-12);
    EXPECT_EQ(static_cast<std::int64_t>(result.series.size()), result.steps);
    for (std::size_t i = 0; i < result.raster("max_depth").values.size(); ++i) {
        const double depth = result.raster("max_depth").values[i];
        EXPECT_EQ(std::isnan(depth), std::isnan(result.raster("arrival_time").values[i]));
        EXPECT_EQ(std::isnan(depth), std::isnan(result.raster("max_velocity").values[i]));
        if (std::isnan(depth) || std::isnan(result.raster("final_depth").values[i])) continue;
        EXPECT_LE(result.raster("final_depth").values[i], depth + 1e-12);
    }
}

const Raster* named(const std::vector<NamedRaster>& rasters, const std::string& name) {
    for (const NamedRaster& raster : rasters)
        if (raster.name == name) return &raster.values;
    return nullptr;
}

TEST(StructuredRun, FluidGivesMaximaArrivalSeriesAndBudget) {
    RunOptions options;
    options.on_frame = [&](const Frame& frame) { EXPECT_TRUE(frame.more.empty()); };
    const RunResult result = run(slope(false), options);
    budget_closes(result);
    EXPECT_EQ(result.particles_peak, 0);
    ASSERT_NE(named(result.rasters, "fluid_velocity"), nullptr);
    // Water falls 30 m: less than 2 sqrt(g H), more than a slow creep.
    double fastest = 0;
    for (const double v : result.raster("max_velocity").values) fastest = std::max(fastest, std::isnan(v) ? 0 : v);
    EXPECT_GT(fastest, 5);
    EXPECT_LT(fastest, 2 * std::sqrt(9.81 * 32));
    // Where the water stood at the start it arrived at time 0, under the wall of its edge later.
    EXPECT_EQ(result.raster("arrival_time").at(30, 20), 0);
    EXPECT_GT(result.raster("arrival_time").at(30, 60), 1);
}

TEST(StructuredRun, SolidsAndFluidShowTheirPhasesAndLoseNothing) {
    RunOptions options;
    std::size_t phases = 0;
    options.on_frame = [&](const Frame& frame) { phases = frame.more.size(); };
    const RunResult result = run(slope(true), options);
    budget_closes(result);
    EXPECT_GT(result.particles_initial, 1000);
    EXPECT_GT(result.particle_steps, result.particles_initial);
    EXPECT_EQ(phases, 8u);
    const Raster* solids = named(result.rasters, "solid_depth");
    ASSERT_NE(solids, nullptr);
    double volume = 0;
    for (const double d : solids->values) volume += std::isnan(d) ? 0 : d * 4;
    EXPECT_NEAR(volume, 0.5 * k_released, 0.01 * k_released);  // but for cells under a centimetre
    for (const char* fraction : {"cohesion_ratio", "solid_fraction"}) {
        const Raster* raster = named(result.rasters, fraction);
        ASSERT_NE(raster, nullptr) << fraction;
        for (const double value : raster->values) EXPECT_TRUE(std::isnan(value) || (value >= 0 && value <= 1 + 1e-12));
    }
}

TEST(StructuredRun, ALakeIsStillAtOnce) {
    Scene scene = slope(false);
    scene.terrain = Raster(scene.grid, 100);
    scene.release[0].outline = {{{{600000, 5000000}, {600240, 5000000}, {600240, 5000120}, {600000, 5000120}}, {}}};
    scene.numerics.boundary = Boundary::wall;
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.stop_reason, StopReason::still);
    EXPECT_LE(result.steps, 12);
}

TEST(StructuredRun, FluidFailsLaterAndFlowsIn) {
    Scene scene = slope(false);
    scene.terrain_contains_release = true;
    scene.release[0].start = 2;
    scene.inflows = {{{{600100, 5000050}, {600100, 5000070}}, {{0, 0, 2}, {1, 20, 2}, {4, 20, 2}, {5, 0, 2}}, {}}};
    const RunResult result = run(scene, {});
    EXPECT_NEAR(result.volume_inflow, 80, 1e-9);
    EXPECT_NEAR(result.volume_entered, k_released + 80, 1e-6);
    EXPECT_LT(relative_volume_error(result), 1e-12);
    EXPECT_TRUE(result.released[0].failed);
    EXPECT_GE(result.raster("arrival_time").at(30, 20), 2);
}

// A gauge and a section across the run-out: what passed is what lies beyond and what left.
TEST(StructuredRun, SectionCountsWhatPasses) {
    Scene scene = slope(false);
    scene.numerics.cfl = 0.25;  // rows at every step, for the trapezium
    scene.recording.gauges = {{"foot", {600150, 5000060}}};
    scene.recording.sections = {{"foot", {{600150, 5000120}, {600150, 5000000}}}};  // eastwards is to its left
    const RunResult result = run(scene, {});
    double beyond = result.volume_left;
    for (std::int64_t r = 0; r < 60; ++r)
        for (std::int64_t c = 75; c < 120; ++c) {
            const double d = result.raster("final_depth").at(r, c);
            beyond += std::isnan(d) ? 0 : d * 4;
        }
    ASSERT_FALSE(result.sections.empty());
    ASSERT_GT(beyond, 100);
    // Steps of the trapezium and films under a centimetre: 3 %.
    EXPECT_NEAR(std::abs(result.sections.back().volume), beyond, 0.03 * beyond);
    double deepest = 0;
    for (const GaugeRow& row : result.gauges) deepest = std::max(deepest, row.depth);
    EXPECT_GT(deepest, 0.1);
}

// Water that breaks a dam of 8 m, 40 m before a vertical step, without friction. At the lip it is as fast as beside it:
// the slope between the cells above and below, 0.25 to 60 here, is no path that it has run. It passes the lip faster
// than its waves: as much as on level ground (Ritter 1892), 97.5 m2 in 10 s, but for where in its cell the lip is: the
// content of one, 2.13 m deep.
TEST(StructuredRun, ALipIsNeitherFastNorADam) {
    constexpr double k_edge = 120, k_deep = 8, k_passed = 97.46, k_lip_depth = 2.13;
    for (const double height : {5.0, 50.0, 150.0}) {
        for (const double cell : {10.0, 5.0, 2.5, 1.25}) {
            Scene scene;
            const auto columns = static_cast<std::int64_t>(400 / cell);
            const double north = 5000000 + 4 * cell;
            scene.grid = {600000, north, cell, columns, 4, ""};
            scene.terrain = Raster(scene.grid);
            for (std::int64_t r = 0; r < 4; ++r)
                for (std::int64_t c = 0; c < columns; ++c)
                    scene.terrain.at(r, c) = (static_cast<double>(c) + 0.5) * cell < k_edge ? 100 + height : 100;
            scene.release = {{{{{{600000, 5000000}, {600080, 5000000}, {600080, north}, {600000, north}}, {}}},
                              k_deep,
                              {},
                              {},
                              false}};
            scene.structured = StructuredMaterial{};
            scene.structured->solids = false;
            scene.structured->manning = 0;
            scene.numerics.boundary = Boundary::wall;
            scene.time.end = 10;
            const RunResult result = run(scene, {});
            EXPECT_EQ(result.stop_reason, StopReason::end_time);
            const auto lip = static_cast<std::int64_t>(k_edge / cell) - 1;
            const Raster& speed = result.raster("max_velocity");
            EXPECT_LT(speed.at(1, lip), 1.2 * speed.at(1, lip - 1)) << height << " m, " << cell << " m";
            EXPECT_GT(speed.at(1, lip), speed.at(1, lip - 1) / 1.2) << height << " m, " << cell << " m";
            const Raster& pressure = result.raster("max_pressure");
            EXPECT_LT(pressure.at(1, lip), 1.44 * pressure.at(1, lip - 1)) << height << " m, " << cell << " m";
            double passed = 0;
            for (std::int64_t c = lip + 1; c < columns; ++c) {
                const double depth = result.raster("final_depth").at(1, c);
                passed += std::isnan(depth) ? 0 : depth * cell;
            }
            EXPECT_NEAR(passed, k_passed, k_lip_depth * cell) << height << " m, " << cell << " m";
        }
    }
}

// Loose solids that slide at 15 m/s over a vertical step are not faster at its lip than before it.
TEST(StructuredRun, SolidsAreNotFasterAtALip) {
    for (const double height : {5.0, 150.0}) {
        for (const double cell : {10.0, 5.0, 2.5}) {
            Scene scene;
            const auto columns = static_cast<std::int64_t>(240 / cell);
            scene.grid = {600000, 5000080, cell, columns, static_cast<std::int64_t>(80 / cell), ""};
            scene.terrain = Raster(scene.grid);
            for (std::int64_t r = 0; r < scene.grid.rows; ++r)
                for (std::int64_t c = 0; c < columns; ++c)
                    scene.terrain.at(r, c) = (static_cast<double>(c) + 0.5) * cell < 120 ? 100 + height : 100;
            scene.release = {{{{{{600030, 5000020}, {600090, 5000020}, {600090, 5000060}, {600030, 5000060}}, {}}}, 3}};
            scene.release[0].speed = 15;
            scene.release[0].azimuth = M_PI / 2;
            scene.structured = StructuredMaterial{};
            scene.structured->cohesion = 0;
            scene.structured->friction = std::tan(30 * M_PI / 180);
            scene.structured->bed_friction = std::tan(10 * M_PI / 180);
            scene.structured->young_modulus = scene.structured->bulk_modulus = 2e5;
            scene.numerics.particles_per_cell = 9;
            scene.time.end = 4;
            const RunResult result = run(scene, {});
            const auto lip = static_cast<std::int64_t>(120 / cell) - 1;
            const auto row = scene.grid.rows / 2;
            const Raster& speed = result.raster("max_velocity");
            EXPECT_LT(speed.at(row, lip), 1.2 * speed.at(row, lip - 1)) << height << " m, " << cell << " m";
            EXPECT_GT(speed.at(row, lip + 1), 5) << height << " m, " << cell << " m";
        }
    }
}

TEST(StructuredRun, EstimateFitsTheScene) {
    const RunEstimate fluid = estimate(slope(false), 1), both = estimate(slope(true), 1);
    EXPECT_EQ(fluid.particles, 0);
    EXPECT_NEAR(fluid.volume, k_released, 1e-9 * k_released);
    EXPECT_GT(fluid.first_step_seconds, 0);
    EXPECT_GT(both.particles, 1000);
    EXPECT_GT(both.bytes_per_particle, 100);
}

}  // namespace
}  // namespace frana
