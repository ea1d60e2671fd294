// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "analysis/trace.h"
#include "small_scene.h"
#include "support/problems.h"

namespace frana::test {
namespace {

std::vector<facade::Problem> problems_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const facade::Error& error) {
        return error.problems();
    }
    return {};
}

std::vector<double> on_small_grid(double value) {
    return std::vector<double>(static_cast<std::size_t>(k_small_grid.rows * k_small_grid.columns), value);
}

TEST(FacadeScene, ReadsElevationsWhereTheyAreAndKeepsThem) {
    auto z = std::make_shared<std::vector<double>>(small_slope());
    const std::weak_ptr<std::vector<double>> watch = z;
    auto scene = std::make_unique<facade::Scene>(k_small_grid, facade::Values{*z, z});
    scene->set("material.friction-coefficient", 0.3);
    scene->set("time.end", 1);
    scene->add_release({.outline = {{square(600020, 5000040, 40)}}, .thickness = 2});
    (*z)[0] = 777;  // in the same memory, before a run begins
    z.reset();
    auto run = std::make_unique<facade::Run>(*scene);
    scene.reset();
    EXPECT_FALSE(watch.expired()) << "the run reads it";
    auto result = std::make_unique<facade::Result>(run->result());
    run.reset();
    const facade::Raster bed = result->raster("bed");
    EXPECT_EQ(bed.at(0, 0), 777);
    result.reset();
    EXPECT_EQ(bed.at(0, 0), 777) << "a raster keeps its memory";
}

TEST(FacadeScene, TellsAllProblemsAtOnce) {
    const std::vector<double> z = small_slope();
    facade::Scene scene(k_small_grid, {z});
    scene.set("material.bed-friction", "chezy");
    EXPECT_EQ(problems_of([&] { static_cast<void>(scene.check()); }).size(), 2U) << "no release, no chezy";
    scene.add_release({.outline = {{square(600020, 5000040, 400)}}, .thickness = -1});
    const auto problems = problems_of([&] { facade::Run run(scene); });
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0].where, "scene: material.chezy");
    EXPECT_EQ(problems[1].where, "release 1");
    EXPECT_TRUE(has_problem(problems, "release 1", "west 600020.00, south 5000040.00, east 600420.00, north 5000440.00",
                            "west 600000.00, south 5000000.00, east 600240.00, north 5000120.00"));
}

TEST(FacadeScene, RefusesWrongValues) {
    std::vector<double> z = small_slope();
    EXPECT_EQ(problems_of([&] { facade::Scene({0, 0, 1, 7, 9}, {z}); }).front().where, "elevations");
    EXPECT_EQ(problems_of([&] { facade::Scene({0, 0, -1, 30, 60}, {z}); }).front().where, "grid: cell size");
    facade::Scene scene = small_scene(z);
    EXPECT_TRUE(scene.check().empty());
    EXPECT_TRUE(has_problem(problems_of([&] { scene.set("material.densty", 1); }), "material.densty"));
    EXPECT_EQ(problems_of([&] { scene.set_values("zones.density", {z}); }).size(), 1U);
    EXPECT_EQ(problems_of([&] { scene.set_walls({std::span(z).first(3)}); }).size(), 1U);
    z[5] = -9999;
    ASSERT_EQ(scene.check().size(), 1U) << "a value for nodata that is none";
    z[5] = 3e38;
    EXPECT_TRUE(has_problem(problems_of([&] { static_cast<void>(scene.check()); }), "elevations", "3e+38 m"));
    z[5] = 100;
    facade::Scene hole = small_scene(z);
    z[15 * 60 + 10] = NAN;
    const auto no_data = problems_of([&] { static_cast<void>(hole.check()); });
    EXPECT_TRUE(has_problem(no_data, "terrain.dtm"));
    EXPECT_NE(no_data.front().value.find("row 15 column 10"), std::string::npos) << no_data.front().value;
}

TEST(FacadeScene, ReadsNumbersByTheRuleOfFiles) {
    const std::vector<double> z = small_slope();
    const auto problems = [&](double thickness, std::optional<double> volume) {
        facade::Scene scene(k_small_grid, {z});
        scene.set("material.friction-angle", 10);
        scene.add_release({.outline = {{square(600020, 5000040, 40)}}, .thickness = thickness, .volume = volume});
        return problems_of([&] { static_cast<void>(scene.check()); });
    };
    EXPECT_TRUE(problems(2, 1000).empty());
    for (const double volume : {1e300, -1.0, 0.0, std::nan(""), HUGE_VAL}) {
        ASSERT_EQ(problems(2, volume).size(), 1U) << volume;
        EXPECT_EQ(problems(2, volume).front().where, "release 1: volume");
    }
    // Within the key's range, but 6 km thick on 1600 m2.
    ASSERT_EQ(problems(2, 1e7).size(), 1U);
    EXPECT_TRUE(has_problem(problems(2, 1e7), "release 1: volume", "6250 m", "at most 2000 m"));
    for (const double thickness : {std::nan(""), HUGE_VAL, 0.0, 1e300})
        EXPECT_EQ(problems(thickness, std::nullopt).size(), 1U) << thickness;
    EXPECT_TRUE(has_problem(problems(std::nan(""), std::nullopt), "release 1", "nan"));
}

TEST(FacadeScene, TakesThicknessesByCellWithTheirVolume) {
    const std::vector<double> z = small_slope();
    std::vector<double> thickness = on_small_grid(NAN);
    double sum = 0;
    for (std::int64_t row = 8; row < 20; ++row)
        for (std::int64_t column = 4; column < 14; ++column)
            sum += thickness[static_cast<std::size_t>(row * 60 + column)] = 1 + 0.1 * static_cast<double>(row % 3);
    facade::Scene scene(k_small_grid, {z});
    scene.set("material.friction-coefficient", 0.3);
    scene.set("time.end", 1);
    facade::Scene wrong = scene, twice = scene, by_key = scene;
    scene.add_release({.thicknesses = {thickness}});
    EXPECT_NEAR(facade::run(scene).number("volume.initial_m3"), 16 * sum, 1e-9 * 16 * sum);
    by_key.add_release({.thicknesses = {thickness}});
    by_key.set("release.volume", 500);
    EXPECT_NEAR(facade::run(by_key).number("volume.initial_m3"), 500, 1e-9);
    twice.add_release({.thicknesses = {thickness}, .volume = 100});
    EXPECT_NEAR(facade::run(twice).number("volume.initial_m3"), 100, 1e-9);
    thickness[700] = -2;
    wrong.add_release({.thicknesses = {thickness}});
    EXPECT_TRUE(has_problem(problems_of([&] { static_cast<void>(wrong.check()); }), "release 1", "-2 m", "0 or more"));
}

TEST(FacadeScene, TakesValuesByPlaceAndWalls) {
    const std::vector<double> z = small_slope();
    std::vector<double> angle = on_small_grid(NAN), wall = on_small_grid(0);
    for (std::int64_t row = 0; row < 30; ++row)
        for (std::int64_t column = 15; column < 60; ++column) angle[static_cast<std::size_t>(row * 60 + column)] = 60;
    const auto run_out = [](const facade::Scene& scene) { return facade::run(scene).number("runout.horizontal_m"); };
    const double without = run_out(small_scene(z));
    facade::Scene rough = small_scene(z);
    rough.set_values("zones.friction-angle", {angle});
    EXPECT_LT(run_out(rough), without - 10);
    angle[3] = 91;
    EXPECT_TRUE(
        has_problem(problems_of([&] { static_cast<void>(rough.check()); }), "zones.friction-angle", "91 degrees"));
    for (std::int64_t row = 0; row < 30; ++row) wall[static_cast<std::size_t>(row * 60 + 17)] = 1;
    facade::Scene walled = small_scene(z);
    walled.set_walls({wall});
    EXPECT_LT(run_out(walled), without - 10);
    wall[0] = 0.5;
    EXPECT_EQ(problems_of([&] { static_cast<void>(walled.check()); }).front().where, "walls");
    facade::Scene unread = small_scene(z);
    unread.set_values("zones.cohesion", {wall});
    EXPECT_FALSE(problems_of([&] { static_cast<void>(unread.check()); }).empty()) << "no law reads it";
}

TEST(CellOutlines, FollowTheEdgesOfCells) {
    GridSpec grid;
    grid.west = 10;
    grid.north = 5;
    grid.columns = 6;
    grid.rows = 5;
    // An area with a hole of two cells that touch at a corner, and a cell that touches the area at a corner.
    const std::vector<double> cells{1, 1, 1, 1, 0,   0,  //
                                    1, 0, 1, 1, 0,   0,  //
                                    1, 1, 0, 1, NAN, 0,  //
                                    1, 1, 1, 1, 0,   0,  //
                                    0, 0, 0, 0, 1,   -1};
    const MultiPolygon outlines = outlines_where_positive(grid, cells);
    ASSERT_EQ(outlines.size(), 2U);
    EXPECT_EQ(area(outlines[0]), 14);
    EXPECT_EQ(outlines[0].outer.size(), 4U) << "corners only";
    EXPECT_EQ(area(outlines[1]), 1);
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column)
            EXPECT_EQ(contains(outlines, grid.cell_centre(row, column)),
                      cells[static_cast<std::size_t>(row * grid.columns + column)] > 0)
                << row << " " << column;
    EXPECT_TRUE(outlines_where_positive(grid, std::vector<double>(30, 0)).empty());
}

// The slope has no curvature across it and lies below 1000 m: of 3200 m3 and 300 years mu = 0.28, xi = 1500 everywhere.
TEST(FacadeScene, TakesItsFrictionFromATable) {
    const std::vector<double> z = small_slope(), mu = on_small_grid(0.28), xi = on_small_grid(1500);
    const auto scene_with = [&](const std::vector<std::pair<std::string, std::string>>& keys) {
        facade::Scene scene(k_small_grid, {z});
        for (const auto& [key, value] : keys) scene.set(key, value);
        scene.set("time.end", 4);
        scene.add_release({.outline = {{square(600020, 5000040, 40)}}, .thickness = 2});
        return scene;
    };
    facade::Scene by_place = scene_with({{"material.friction-coefficient", "0.5"}});
    by_place.set_values("zones.friction-coefficient", {mu});
    by_place.set_values("zones.turbulence", {xi});
    const facade::Raster expected = facade::run(by_place).raster("max_depth");
    const facade::Raster found =
        facade::run(scene_with({{"material.friction-table", "ngi-avalanche"}, {"material.return-period", "300"}}))
            .raster("max_depth");
    for (std::int64_t row = 0; row < k_small_grid.rows; ++row)
        for (std::int64_t column = 0; column < k_small_grid.columns; ++column) {
            const double a = expected.at(row, column), b = found.at(row, column);
            ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << row << ", " << column;
        }
}

}  // namespace
}  // namespace frana::test
