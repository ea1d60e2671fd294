// SPDX-License-Identifier: Apache-2.0
// What must not happen is seen at the step at which it happens, with its place.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/simulation.h"
#include "simulation/trouble_watch.h"

namespace frana {
namespace {

using Kind = Trouble::Kind;

enum class Of { mass, fluid, solids };

// 2 m on a slope of 1 : 2 that runs out on the flat; it falls 30 m.
Scene slope(Of of) {
    Scene scene;
    scene.grid = {600000, 5000120, 2, 120, 60, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < 60; ++r) {
        for (std::int64_t c = 0; c < 120; ++c)
            scene.terrain.at(r, c) = 100 + std::max(0.0, 0.5 * (60 - 2.0 * static_cast<double>(c)));
    }
    ReleaseArea area;
    area.outline = {{{{600020, 5000040}, {600040, 5000040}, {600040, 5000080}, {600020, 5000080}}, {}}};
    area.thickness = 2;
    scene.release = {area};
    scene.material.friction_coefficient = 0.3;
    if (of != Of::mass) {
        scene.structured = StructuredMaterial{};
        scene.structured->solids = of == Of::solids;
        scene.structured->young_modulus = scene.structured->bulk_modulus = 2e5;
        scene.structured->friction = scene.structured->bed_friction = 0.4;
    }
    scene.time.end = of == Of::solids ? 0.5 : 6;
    scene.time.frame_interval = 0.25;
    return scene;
}

bool inside_release(Point p) {
    return p.x > 600015 && p.x < 600045 && p.y > 5000035 && p.y < 5000085;
}

bool finite_or_no_data(const Raster& raster) {
    for (const double v : raster.values)
        if (std::isinf(v)) return false;
    return true;
}

class AnyMaterial : public testing::TestWithParam<Of> {};

TEST_P(AnyMaterial, AGoodRunHasNoTrouble) {
    RunOptions options;
    options.on_trouble = [](const Trouble& trouble) { ADD_FAILURE() << describe(trouble); };
    const RunResult result = run(slope(GetParam()), options);
    EXPECT_TRUE(result.hard_events.none());
    EXPECT_TRUE(result.troubles.empty());
}

// A mass that starts at 1e200 m/s: the first step cannot be told in numbers.
TEST_P(AnyMaterial, NumbersThatAreNoneEndTheRunAtTheirStep) {
    Scene scene = slope(GetParam());
    scene.release[0].speed = 1e200;
    std::vector<Trouble> seen;
    int frames = 0;
    RunOptions options;
    options.on_trouble = [&](const Trouble& trouble) { seen.push_back(trouble); };
    options.on_frame = [&](const Frame& frame) {
        ++frames;
        EXPECT_TRUE(finite_or_no_data(frame.depth) && finite_or_no_data(frame.velocity));
    };
    const RunResult result = run(scene, options);
    EXPECT_EQ(result.stop_reason, StopReason::non_finite);
    EXPECT_GT(result.hard_events.non_finite, 0);
    EXPECT_EQ(frames, 2) << "the start and the end";
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen[0].kind, Kind::non_finite);
    EXPECT_EQ(seen[0].step, result.steps);
    EXPECT_LE(result.steps, 2);
    ASSERT_TRUE(seen[0].place);
    EXPECT_TRUE(inside_release(*seen[0].place)) << describe(seen[0]);
    for (const auto raster : {&RunResult::max_depth, &RunResult::max_velocity, &RunResult::final_depth})
        EXPECT_TRUE(finite_or_no_data(result.*raster));
}

// Gravity that grows a hundredfold is what a wrong unit would do: nothing is infinite, but no fall explains the speed.
TEST_P(AnyMaterial, ASpeedAboveTheBoundEndsTheRunAtItsStep) {
    Scene scene = slope(GetParam());
    const Release release = make_release(scene);
    const Arrivals arrivals(scene, {});
    const double bound = TroubleWatch(scene, release, arrivals, 1).greatest_speed();
    // 32 m from the surface to the flat, with the top of the release at x = 20: 20 + 2 m; less the half cell's bed.
    EXPECT_NEAR(bound, std::sqrt(2 * 9.81 * 21.5) + 2 * std::sqrt(9.81 * 2), 0.5);
    Trouble seen{};
    RunOptions options;
    options.on_trouble = [&](const Trouble& trouble) { seen = trouble; };
    scene.release[0].speed = 1e6;  // allowed for in the bound: no trouble by itself
    scene.time.end = 1e-6;
    EXPECT_EQ(run(scene, options).stop_reason, StopReason::end_time);
}

TEST_P(AnyMaterial, GroundWithoutElevationIsLocated) {
    Scene scene = slope(GetParam());
    for (std::int64_t r = 0; r < 60; ++r) scene.terrain.at(r, 21) = k_no_data;  // 2 m beyond the release
    scene.release[0].speed = 8;
    Trouble seen{};
    RunOptions options;
    options.on_trouble = [&](const Trouble& trouble) { seen = trouble; };
    const RunResult result = run(scene, options);
    ASSERT_EQ(result.stop_reason, StopReason::reached_no_data);
    EXPECT_GT(result.hard_events.entered_no_data, 0);
    ASSERT_TRUE(seen.place);
    EXPECT_NEAR(seen.place->x, 600043, 3) << describe(seen);
    EXPECT_EQ(seen.step, result.steps);
}

INSTANTIATE_TEST_SUITE_P(Trouble, AnyMaterial, testing::Values(Of::mass, Of::fluid, Of::solids), [](const auto& tested) {
    return tested.param == Of::mass ? "Mass" : tested.param == Of::fluid ? "Fluid" : "Solids";
});

}  // namespace
}  // namespace frana
