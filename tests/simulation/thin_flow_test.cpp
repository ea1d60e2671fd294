// SPDX-License-Identifier: Apache-2.0
// A flow thinner than visible on maps is not at rest while it moves, and a release so thin is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/error.h"
#include "physics/laws.h"
#include "simulation/simulation.h"
#include "support/problems.h"

namespace frana {
namespace {

// Cells of a given size on an even slope of 17 degrees without friction, and a release in the middle of its upper part.
Scene slope(double cell, double side, double thickness, bool fluid) {
    Scene scene;
    scene.grid = {0, 40 * cell, cell, 80, 40, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r)
        for (std::int64_t c = 0; c < scene.grid.columns; ++c)
            scene.terrain.at(r, c) = 0.3 * cell * static_cast<double>(scene.grid.columns - c);
    const double west = 15.2 * cell, south = 20.2 * cell;
    scene.release = {
        {{{{{west, south}, {west + side, south}, {west + side, south + side}, {west, south + side}}, {}}}, thickness}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.02;
    if (fluid) {
        scene.structured.emplace();
        scene.structured->manning = 0.02;
    }
    scene.time.end = 30;
    return scene;
}

class ThinFlow : public testing::TestWithParam<bool> {};

TEST_P(ThinFlow, AWideFilmIsRefusedWithTheKeyThatShowsIt) {
    Scene scene = slope(50, 500, 0.005, GetParam());
    try {
        run(scene, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(has_problem(error.problems(), "release.thickness", "0.005 m at most, mean over cells of 50 m",
                                "at least numerics.minimum-depth = 0.01 m"));
        const std::string& remedy = error.problems().front().remedy;
        EXPECT_NE(remedy.find("numerics.minimum-depth = 0.0005 "), std::string::npos) << remedy;
    }
    EXPECT_THROW(estimate(scene, 1), Error);
    // Following the remedy: then the map shows it, far down the slope.
    scene.numerics.minimum_depth = 0.0005;
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.stop_reason, StopReason::end_time);
    double farthest = 0;
    for (std::int64_t r = 0; r < scene.grid.rows; ++r)
        for (std::int64_t c = 0; c < scene.grid.columns; ++c)
            if (result.raster("max_depth").at(r, c) > 0) farthest = std::max(farthest, static_cast<double>(c));
    EXPECT_GT(farthest, 26) << "released up to column 25";
}

TEST_P(ThinFlow, AReleaseSmallerThanACellIsRefused) {
    const Scene scene = slope(10, 0.9, 1, GetParam());  // 0.81 m3 in 100 m2
    EXPECT_THROW(run(scene, {}), Error);
}

// Two centimetres on a flume of 4 m: soon thinner than the minimum depth, and still moving.
TEST_P(ThinFlow, AFlumeIsNotAtRestWhileItFlows) {
    Scene scene = slope(0.05, 0.25, 0.02, GetParam());
    scene.time.end = 10;  // of fluid, the rest after 15 s is thinner than the solver moves
    const RunResult result = run(scene, {});
    EXPECT_NE(result.stop_reason, StopReason::still) << result.simulated_seconds;
    EXPECT_GT(result.thin_fraction, 0.5);
}

INSTANTIATE_TEST_SUITE_P(, ThinFlow, testing::Bool(), [](const auto& fluid) { return fluid.param ? "Fluid" : "Mass"; });

}  // namespace
}  // namespace frana
