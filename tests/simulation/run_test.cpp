// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/laws.h"
#include "simulation/run_warnings.h"
#include "simulation/simulation.h"

namespace frana {
namespace {

// A slide of 2 m on a 27 degree slope that ends on the flat.
Scene slide() {
    Scene scene;
    scene.grid = {600000, 5000120, 2, 120, 60, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < 60; ++r) {
        for (std::int64_t c = 0; c < 120; ++c)
            scene.terrain.at(r, c) = 100 + std::max(0.0, 0.5 * (120 - 2.0 * static_cast<double>(c)));
    }
    scene.release = {
        {{{{{600030, 5000040}, {600060, 5000040}, {600060, 5000080}, {600030, 5000080}}, {}}}, 2, {}, {}, false}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.3;
    scene.time.end = 40;
    scene.time.frame_interval = 2;
    return scene;
}

// A result of which only what a test adds is worth telling.
RunResult metre_everywhere(const Scene& scene) {
    RunResult result;
    result.add("bed", scene.terrain);
    for (const char* name : {"final_depth", "max_depth", "release"}) result.add(name, Raster(scene.grid, 1.0));
    return result;
}

bool is_told(const RunResult& result, const Scene& scene, const char* words) {
    const std::vector<std::string> texts = texts_of(run_warnings(result, scene));
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(words) != std::string::npos; });
}

// Down a gully of 6 m between banks of 63 degrees: at the most 12.3 and 9.9 m/s by particles and finite volumes
// on 10 m, 13.5 and 14.0 on 5 m, 16.4 and 16.6 on 1.25 m.
TEST(Run, TellsOfAFlowOfFewCells) {
    const auto told = [](double cell, Scheme scheme) {
        Scene scene;
        const auto columns = static_cast<std::int64_t>(400 / cell), rows = static_cast<std::int64_t>(120 / cell);
        scene.grid = {600000, 5000120, cell, columns, rows, ""};
        scene.terrain = Raster(scene.grid);
        for (std::int64_t r = 0; r < rows; ++r)
            for (std::int64_t c = 0; c < columns; ++c) {
                const double y = (static_cast<double>(r) + 0.5) * cell - 60, x = (static_cast<double>(c) + 0.5) * cell;
                scene.terrain.at(r, c) = 100 + 0.4 * (400 - x) + 2 * std::max(0.0, std::abs(y) - 3);
            }
        scene.release = {
            {{{{{600020, 5000056}, {600080, 5000056}, {600080, 5000064}, {600020, 5000064}}, {}}}, 2, {}, {}, false}};
        scene.material.of<CoulombFriction>().friction_coefficient = 0.1;
        scene.material.of<TurbulentFriction>().turbulence = 500;
        scene.numerics.scheme = scheme;
        scene.time.end = 15;
        return is_told(run(scene, {}), scene, "cells wide");
    };
    for (const Scheme scheme : {Scheme::standard, Scheme::finite_volume}) {
        EXPECT_TRUE(told(5, scheme));
        EXPECT_FALSE(told(1.25, scheme));
    }
}

TEST(Run, GivesMaximaArrivalSeriesAndBudget) {
    const Scene scene = slide();
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.stop_reason, StopReason::still);
    EXPECT_TRUE(result.hard_events.none());
    EXPECT_NEAR(result.volume_initial, 2 * 30 * 40, 1e-9 * result.volume_initial);
    EXPECT_NEAR(result.volume_final + result.volume_left, result.volume_initial, 1e-12 * result.volume_initial);
    EXPECT_EQ(static_cast<std::int64_t>(result.series.size()), result.steps);
    double seen = 0;
    for (std::size_t i = 0; i < result.raster("max_depth").values.size(); ++i) {
        const double depth = result.raster("max_depth").values[i];
        EXPECT_EQ(std::isnan(depth), std::isnan(result.raster("arrival_time").values[i]));
        EXPECT_EQ(std::isnan(depth), std::isnan(result.raster("max_velocity").values[i]));
        if (std::isnan(depth)) continue;
        seen = std::max(seen, depth);
        if (!std::isnan(result.raster("final_depth").values[i])) {
            EXPECT_LE(result.raster("final_depth").values[i], depth + 1e-12);
        }
        EXPECT_NEAR(result.raster("max_pressure").values[i],
                    2000 * std::pow(result.raster("max_velocity").values[i], 2) / 1000, 1e-9);
    }
    EXPECT_GE(seen, 1.9);
    EXPECT_LT(seen, 4);
}

// A cliff of 40 m in the slope; with material points the flow jumps over it, and nothing has to be told.
TEST(Run, FiniteVolumesNameWhatACliffWouldThrow) {
    const auto told = [](double cliff, Scheme scheme) {
        Scene scene = slide();
        scene.numerics.scheme = scheme;
        scene.terrain.values.change_each_stored([&](std::size_t cell, double& z) { z += cell % 120 < 40 ? cliff : 0; });
        const RunResult result = run(scene, {});
        for (const Warning& warning : result.warnings)
            if (warning.words.text().find("would fly at") != std::string::npos) {
                EXPECT_TRUE(warning.limits_use);
                EXPECT_NEAR(warning.place.value_or(Point{}).x, 600000 + 80, 4);
                return true;
            }
        return false;
    };
    EXPECT_TRUE(told(40, Scheme::finite_volume));
    EXPECT_FALSE(told(40, Scheme::standard));
    EXPECT_FALSE(told(0, Scheme::finite_volume));
}

// On a plane of any slope a pile may stand as high as friction carries between cells of 2 m, and no higher.
TEST(Run, APileThatFrictionDoesNotCarryIsNamed) {
    Scene scene = slide();  // friction 0.3
    RunResult result = metre_everywhere(scene);
    result.stop_reason = StopReason::settled;
    EXPECT_FALSE(highest_pile(result, scene));
    Raster& depth = result.rasters[1].values;
    depth.at(30, 20) = 1 + 0.59;
    EXPECT_FALSE(highest_pile(result, scene));
    depth.at(30, 20) = 1 + 1.0;
    const auto pile = highest_pile(result, scene);
    ASSERT_TRUE(pile);
    EXPECT_NEAR(pile->height, 1 - 0.6 * std::sqrt(2), 1e-12);  // of the diagonals, which are longer; roundings
    EXPECT_NEAR(pile->depth, 2, 1e-12);
    EXPECT_EQ(pile->place.x, 600041);
    EXPECT_EQ(pile->place.y, 5000059);
    const auto is_named = [&] { return is_told(result, scene, "uncertain by"); };
    EXPECT_TRUE(is_named());
    scene.material.bed_friction = {"cohesion"};  // which holds it, too
    EXPECT_FALSE(highest_pile(result, scene));
    scene.material.bed_friction = {"voellmy"};
    // Beside a heap of 20 m, 0.25 in 1 steep, nothing changes by 5 %.
    for (std::int64_t r = 0; r < 60; ++r)
        for (std::int64_t c = 60; c < 120; ++c) {
            const auto away = static_cast<double>(std::max(std::abs(r - 30), std::abs(c - 95)));
            depth.at(r, c) = std::max(1.0, 20 - 0.5 * away);
        }
    EXPECT_FALSE(is_named());
    result.stop_reason = StopReason::end_time;  // a flow that moves has steep fronts
    EXPECT_FALSE(highest_pile(result, scene));
}

// A mass slides as much farther as its energy is too great: from a twentieth on it is told.
TEST(Run, AnErrorOfEnergyThatMovesTheRunOutIsTold) {
    const Scene scene = slide();
    RunResult result = metre_everywhere(scene);
    for (const auto& [error, told] : {std::pair{0.04, false}, {0.06, true}}) {
        result.energy_error = error;
        EXPECT_EQ(is_told(result, scene, "energy error"), told) << error;
    }
}

// A few drops over the edge leave the map as it is.
TEST(Run, ThinFlowIsMissingInFinalDepthForOneReason) {
    const Scene scene = slide();
    RunResult result = metre_everywhere(scene);
    result.volume_final = 1000;
    result.volume_shown = 930;
    for (const auto& [thin, told] : {std::pair{0.0, "final_depth.tif has"}, {0.12, "12 % of flow thinner than"}}) {
        result.thin_fraction = thin;
        int found = 0;
        for (const std::string& text : texts_of(run_warnings(result, scene))) {
            const bool is_told = text.find(told) != std::string::npos;
            found += is_told || text.find("final_depth.tif has") != std::string::npos ? 1 : 0;
            EXPECT_TRUE(is_told || text.find("final_depth.tif has") == std::string::npos) << text;
        }
        EXPECT_EQ(found, 1) << thin;
    }
}

TEST(Run, WhatLeavesIsToldWhereItCounts) {
    const Scene scene = slide();
    RunResult result = metre_everywhere(scene);
    result.volume_entered = 1000;
    result.hard_events.non_finite = 1;
    // They stand on maps, which others get without the files.
    EXPECT_FALSE(is_told(result, scene, "hard_events"));
    for (const auto& [left, told] : {std::pair{0.5, false}, {2.0, true}}) {
        result.volume_left = left;
        EXPECT_EQ(is_told(result, scene, "left the computed ground"), told) << left;
    }
}

TEST(Run, OfAFlowThatEndsAtRestNoPileIsNamed) {
    const Scene scene = slide();
    const RunResult result = run(scene, {});
    ASSERT_EQ(result.stop_reason, StopReason::still);
    for (const std::string& text : texts_of(result.warnings))
        EXPECT_EQ(text.find("uncertain by"), std::string::npos) << text;
}

// Thin before the step, of the volume before the step: what left in it counts in both.
TEST(Run, NoMoreThanAllOfAFlowIsThin) {
    Scene scene = slide();
    scene.release[0].outline = {{{{600010, 5000010}, {600238, 5000010}, {600238, 5000110}, {600010, 5000110}}, {}}};
    scene.release[0].thickness = 0.011;
    scene.material.of<CoulombFriction>().friction_coefficient = 0;
    scene.release[0].speed = 20;
    scene.release[0].azimuth = M_PI / 2;
    scene.numerics.minimum_depth = 0.01;
    scene.time.end = 20;
    const RunResult result = run(scene, {});
    EXPECT_GT(result.volume_left, 0.5 * result.volume_initial);
    EXPECT_GT(result.thin_fraction, 0.5);
    EXPECT_LE(result.thin_fraction, 1);
}

TEST(Estimate, CountsWithoutRunning) {
    const RunEstimate e = estimate(slide(), 1);
    EXPECT_EQ(e.particles, 30 * 40);  // 4 particles for each 4 m2
    EXPECT_NEAR(e.volume, 2400, 1e-6);
    EXPECT_GT(e.memory_bytes, 0);
    EXPECT_GT(e.first_step_seconds, 0);
}

// The momentum of a block is its volume times its speed, which the series has: 5 % of the greatest ends it.
TEST(Run, EndsAtAFractionOfThePeakOfMomentum) {
    Scene scene = slide();
    scene.time.stop_momentum = 0.05;
    const RunResult result = run(scene, {});
    ASSERT_EQ(result.stop_reason, StopReason::momentum);
    // |p| lies between the kinetic energy over half the greatest speed and the root of 2 E M (Cauchy-Schwarz).
    double peak = 0;
    for (const SeriesRow& row : result.series) peak = std::max(peak, std::sqrt(row.kinetic_energy));
    EXPECT_LT(std::sqrt(result.series.back().kinetic_energy), 0.2 * peak);
    scene.time.stop_momentum = 0.5;
    EXPECT_LT(run(scene, {}).simulated_seconds, result.simulated_seconds);
}

// Every row of the series accounts for all the volume, with erosion, deposition, late areas, inflow and outflow.
TEST(Run, EveryRowOfTheSeriesClosesItsBalance) {
    Scene scene = slide();
    for (std::int64_t r = 0; r < 60; ++r)  // down to the eastern edge
        for (std::int64_t c = 0; c < 120; ++c) scene.terrain.at(r, c) = 0.5 * (240 - 2.0 * static_cast<double>(c));
    scene.release.push_back(scene.release[0]);
    scene.release[1].start = 5;
    scene.inflows = {{{{600100, 5000030}, {600100, 5000090}}, {{0, 20, 4}, {12, 20, 4}}, std::nullopt}};
    scene.entrainment.erosion = "growth";
    scene.entrainment.of<GrowthErosion>().growth_rate = 5e-3;
    scene.entrainment.erodible_depth = 0.5;
    scene.entrainment.deposition = true;
    scene.entrainment.of<ShearStressDeposition>().deposition_rate = 0.1;
    scene.entrainment.of<ShearStressDeposition>().deposition_shear = 15000;
    scene.time.end = 30;
    const RunResult result = run(scene, {});
    const SeriesRow& last = result.series.back();
    EXPECT_EQ(last.volume_eroded, result.volume_eroded);
    EXPECT_EQ(last.volume_deposited, result.volume_deposited);
    for (const double part : {last.volume_inflow, last.volume_eroded, last.volume_deposited, last.volume_left})
        EXPECT_GT(part, 10);
    double worst = 0;
    for (const SeriesRow& row : result.series) {
        const double came = row.volume_entered + row.volume_eroded,
                     is = row.volume + row.volume_left + row.volume_deposited;
        worst = std::max(worst, std::abs(came - is) / came);
    }
    EXPECT_LT(worst, 1e-13);
}

}  // namespace
}  // namespace frana
