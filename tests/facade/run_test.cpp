// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "small_scene.h"

namespace frana::test {
namespace {

using facade::Result;

bool same_bits(const facade::Raster& a, const facade::Raster& b) {
    return a.cells.size() == b.cells.size() && std::memcmp(a.cells.data(), b.cells.data(), a.cells.size_bytes()) == 0;
}

TEST(FacadeRun, GivesFramesAtTheirTimesAndThenTheResult) {
    const std::vector<double> z = small_slope();
    facade::Run run(small_scene(z));
    std::vector<double> times;
    std::optional<facade::Raster> last;
    while (const auto frame = run.next()) {
        EXPECT_EQ(frame->index(), static_cast<int>(times.size()));
        times.push_back(frame->time());
        last = frame->raster("depth");
        EXPECT_EQ(last->grid, k_small_grid);
        EXPECT_EQ(last->info.unit, "m");
    }
    ASSERT_EQ(times.size(), 5U);
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), 8);
    EXPECT_FALSE(run.next());
    EXPECT_EQ(run.time(), 8);
    const Result result = run.result();
    EXPECT_EQ(result.stop_reason(), "end-time");
    EXPECT_TRUE(same_bits(*last, result.raster("final_depth"))) << "the memory of a frame outlives it";
    EXPECT_NEAR(result.number("volume.initial_m3"), 2 * 40 * 40, 1e-6);
    EXPECT_EQ(Json::parse(result.summary())["release_areas"][0]["name"], "upper");
    EXPECT_GT(result.number("runout.horizontal_m"), 20);
    const auto series = result.series();
    ASSERT_FALSE(series.empty());
    EXPECT_EQ(series[0].name, "time");
    EXPECT_EQ(series[0].values.size(), static_cast<std::size_t>(result.number("steps")));
    EXPECT_THROW(static_cast<void>(result.number("runout.vertical_m")), facade::Error);
    try {
        static_cast<void>(result.raster("depth"));
        FAIL();
    } catch (const facade::Error& error) {
        EXPECT_NE(error.problems().front().limit.find("max_depth"), std::string::npos) << "the names there are";
    }
}

TEST(FacadeRun, StopsWhenAsked) {
    const std::vector<double> z = small_slope();
    std::atomic<int> steps = 0;
    facade::Options options;
    options.on_progress = [&](double time) { steps += time > 0; };
    options.stop_requested = [&] { return steps >= 3; };
    const Result result = facade::run(small_scene(z), options);
    EXPECT_EQ(result.stop_reason(), "requested");
    EXPECT_LT(result.number("simulated_seconds"), 8);
    facade::Run left(small_scene(z));
    EXPECT_TRUE(left.next());  // and is left
}

TEST(FacadeRun, FailsWhereTheFlowReachesCellsWithoutTerrain) {
    std::vector<double> z = small_slope();
    for (std::int64_t row = 0; row < k_small_grid.rows; ++row)
        for (std::int64_t column = 20; column < 24; ++column)
            z[static_cast<std::size_t>(row * k_small_grid.columns + column)] = NAN;
    facade::Scene scene = small_scene(z);
    try {
        static_cast<void>(facade::run(scene));
        FAIL();
    } catch (const facade::RunFailed& failure) {
        EXPECT_EQ(failure.result().stop_reason(), "reached-no-data");
        ASSERT_FALSE(failure.problems().empty());
        EXPECT_NE(std::string(failure.what()).find(failure.problems().front().what), std::string::npos);
    }
    scene.set("terrain.nodata-policy", "wall");
    EXPECT_EQ(facade::run(scene).stop_reason(), "end-time");
}

TEST(FacadeRun, TakesTheStructuredModel) {
    const std::vector<double> z = small_slope();
    facade::Scene scene(k_small_grid, {z});
    scene.set("material.model", "structured");
    scene.set("structured.phases", "fluid");
    scene.set("time.end", 2);
    scene.add_release({.outline = {{square(600020, 5000040, 40)}}, .thickness = 2});
    const Result result = facade::run(scene);
    EXPECT_GT(result.number("max_velocity_ms"), 1);
    EXPECT_EQ(Json::parse(result.summary())["model"], "structured");
}

}  // namespace
}  // namespace frana::test
