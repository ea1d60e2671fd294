// SPDX-License-Identifier: Apache-2.0
// A run ends when run-out, area and deposit have stopped changing, and not before.
#include "physics/laws.h"
#include "played_runs.h"
#include "simulation/run_summary.h"

namespace frana {
namespace {

double area_over(const Scene& scene, const RunResult& result) {
    double cells = 0;
    for (const double depth : result.raster("max_depth").values) cells += depth >= scene.time.trace_threshold;
    return cells * scene.grid.cell_area();
}

double apart(const Raster& a, const Raster& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        sum += std::abs((std::isnan(a.values[i]) ? 0 : a.values[i]) - (std::isnan(b.values[i]) ? 0 : b.values[i]));
    return 0.5 * sum * a.grid.cell_area();
}

// The results then are those of a run ten times as long.
TEST(Settling, HasTheValuesOfAMuchLongerRun) {
    Scene scene = hillside();
    scene.time.end = 1000;
    scene.time.stop_when_still = false;
    scene.time.stop_change = 0.001;
    const RunResult settled = run(scene, {});
    ASSERT_EQ(settled.stop_reason, StopReason::settled) << settled.simulated_seconds;
    ASSERT_TRUE(settled.settling);
    EXPECT_LE(settled.settling->area, 0.001);
    EXPECT_LE(settled.settling->deposit, 0.008);  // 8 times time.stop-change at most
    EXPECT_LE(settled.settling->runout, scene.grid.cell_size);
    EXPECT_GE(settled.settling->window, 10);
    EXPECT_TRUE(settled.settling->front_is_final);
    scene.time.end = 3 * settled.simulated_seconds;
    scene.time.stop_change = 0;
    const RunResult longer = run(scene, {});
    EXPECT_GT(longer.steps, 2 * settled.steps);
    EXPECT_NEAR(area_over(scene, longer), area_over(scene, settled), 0.01 * area_over(scene, longer));
    EXPECT_LT(apart(longer.raster("final_depth"), settled.raster("final_depth")), 0.02 * longer.volume_entered);
}

// Snow whose tail drains over its slope for minutes: 200 m of drop, 30 degrees, then 6 degrees, friction 0.2.
Scene avalanche(Scheme scheme) {
    Scene scene;
    scene.grid = {0, 300, 10, 100, 30, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r) {
        for (std::int64_t c = 0; c < scene.grid.columns; ++c) {
            const Point p = scene.grid.cell_centre(r, c);
            scene.terrain.at(r, c) =
                300 - 0.1 * p.x + 0.48 * std::max(0.0, 400 - p.x) + 2e-4 * (p.y - 150) * (p.y - 150);
        }
    }
    scene.release = {{{box(20, 90, 120, 210)}, 1}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.2;
    scene.material.of<TurbulentFriction>().turbulence = 1500;
    scene.numerics.scheme = scheme;
    scene.time.end = 900;
    scene.time.stop_when_still = false;
    scene.time.stop_change = 0.005;
    return scene;
}

class SnowSettles : public testing::TestWithParam<Scheme> {};

// What drains and creeps on changes the front by less than a cell, the area by less than half a cell around it, the
// deposit by less than a cell's shift: the errors that the cells have anyway.
TEST_P(SnowSettles, WithinTheErrorOfTheCells) {
    Scene scene = avalanche(GetParam());
    const RunResult settled = run(scene, {});
    ASSERT_EQ(settled.stop_reason, StopReason::settled) << settled.simulated_seconds;
    EXPECT_LT(settled.simulated_seconds, 0.5 * scene.time.end);
    EXPECT_GT(settled.moving_fraction_limit, 0) << "some still moves, and is told";
    scene.time.stop_change = 0;
    const RunResult longer = run(scene, {});
    ASSERT_EQ(longer.stop_reason, StopReason::end_time);
    const auto runout = [&](const RunResult& one) { return run_statistics(one, scene.time.trace_threshold).run_out; };
    EXPECT_LE(std::abs(runout(longer) - runout(settled)), scene.grid.cell_size);
    const double area = area_over(scene, longer), perimeter = 2 * std::sqrt(M_PI * area);  // no shape has a shorter one
    EXPECT_LE(std::abs(area - area_over(scene, settled)), 0.5 * scene.grid.cell_size * perimeter);
    EXPECT_LE(apart(longer.raster("final_depth"), settled.raster("final_depth")),
              settled.settling->deposit_error * longer.volume_entered);
}

INSTANTIATE_TEST_SUITE_P(, SnowSettles, testing::Values(Scheme::standard, Scheme::finite_volume),
                         [](const auto& one) { return one.param == Scheme::standard ? "Particles" : "FiniteVolumes"; });

// A block of 6 by 4 cells that stays: shifted by a cell along its rows a sixth of it would come to lie elsewhere, along
// its columns a quarter.
TEST(Settling, TheErrorOfTheDepositIsThatOfACell) {
    Scene scene;
    scene.grid = {0, 100, 5, 20, 20, ""};
    scene.terrain = Raster(scene.grid);
    scene.release = {{{box(30, 40, 60, 60)}, 2}};
    scene.material.of<CoulombFriction>().friction_coefficient = 1;
    scene.numerics.scheme = Scheme::finite_volume;
    scene.time.end = 12;
    scene.time.stop_when_still = false;
    scene.time.stop_change = 0.005;
    const RunResult result = run(scene, {});
    ASSERT_TRUE(result.settling);
    EXPECT_EQ(result.settling->deposit, 0);
    EXPECT_NEAR(result.settling->deposit_error, (1.0 / 6 + 1.0 / 4) / 2, 1e-12);
}

// On an infinite plane it never settles, however slowly it moves.
TEST(Settling, NeverWhileItRunsOn) {
    Scene scene;
    scene.grid = {0, 100, 5, 400, 20, ""};
    scene.terrain = Raster(scene.grid);
    for (std::int64_t r = 0; r < scene.grid.rows; ++r)
        for (std::int64_t c = 0; c < scene.grid.columns; ++c)
            scene.terrain.at(r, c) = 0.5 * 5 * static_cast<double>(400 - c);
    scene.release = {{{box(100, 30, 160, 70)}, 2}};
    scene.material.of<CoulombFriction>().friction_coefficient = 0.4;
    scene.material.of<TurbulentFriction>().turbulence = 2;  // about half a metre a second
    scene.time.end = 200;
    scene.time.stop_change = 0.001;
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.stop_reason, StopReason::end_time);
    ASSERT_TRUE(result.settling);
    EXPECT_FALSE(result.settling->front_is_final);
}

// A mass that begins to move slowly changes nothing for a while: its kinetic energy is then at its peak.
TEST(Settling, NeverBeforeItHasBegun) {
    Scene scene = hillside();
    scene.release[0].outline = {box(10, 40, 40, 80)};
    for (double& z : scene.terrain.values) z *= 0.01;
    scene.material.of<CoulombFriction>().friction_coefficient = 0.0045;  // the ground falls by 0.006
    scene.time.end = 60;
    scene.time.stop_change = 0.001;
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.stop_reason, StopReason::end_time) << result.simulated_seconds;
}

// The run waits for later areas and inflows, and the window begins with them.
TEST(Settling, WaitsForLaterReleasesAndInflow) {
    Scene scene = hillside();
    scene.release.push_back({{box(60, 50, 80, 70)}, 2});
    scene.release[1].start = 80;
    scene.time.end = 300;
    scene.time.stop_when_still = false;
    scene.time.stop_change = 0.001;
    const RunResult result = run(scene, {});
    EXPECT_EQ(result.stop_reason, StopReason::settled);
    EXPECT_GE(result.simulated_seconds, 90);
    EXPECT_TRUE(result.released[1].failed);
}

}  // namespace
}  // namespace frana
