// SPDX-License-Identifier: Apache-2.0
#include "bench/stability/robustness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/json.h"
#include "simulation/scene.h"

namespace frana::bench {
namespace {

Scene slope() {
    Scene scene;
    scene.numerics.cfl = 0.8;
    scene.grid.cell_size = 5;
    scene.grid.columns = 24;
    scene.grid.rows = 16;
    scene.grid.north = 80;
    scene.terrain = Raster(scene.grid);
    for (std::int64_t row = 0; row < 16; ++row)
        for (std::int64_t column = 0; column < 24; ++column)
            scene.terrain.at(row, column) = 200 - 2.5 * static_cast<double>(column);
    ReleaseArea area;
    area.thickness = 2;
    area.outline = {{{{20, 30}, {50, 30}, {50, 55}, {20, 55}}, {}}};
    scene.release = {area};
    place_origin(scene);
    return scene;
}

// Returns the result of a run, all cells equal except one that is deeper.
RunResult result_of(const Scene& scene, double depth, double speed) {
    RunResult result;
    Raster release(scene.grid, k_no_data), deepest(scene.grid, depth);
    release.at(8, 5) = 2;
    deepest.at(3, 3) = 2 * depth;
    result.add("bed", scene.terrain);
    result.add("release", std::move(release));
    result.add("max_depth", std::move(deepest));
    result.add("final_depth", Raster(scene.grid, depth));
    result.add("max_velocity", Raster(scene.grid, speed));
    result.volume_shown = depth * static_cast<double>(scene.grid.cell_count()) * 25;
    result.volume_final = 1.25 * depth * static_cast<double>(scene.grid.cell_count()) * 25;
    result.steps = 7;
    return result;
}

RobustnessOptions options_of(std::vector<Scene>& seen) {
    RobustnessOptions options;
    options.threshold = 0.1;
    options.scene = [](const std::vector<std::string>& overrides) {
        Scene scene = slope();
        for (const std::string& one : overrides) {
            if (one == "numerics.particles-per-cell=1")
                throw Error(ErrorKind::input, Problem{"is too few", "numerics.particles-per-cell", "1", "", ""});
            if (one.starts_with("numerics.cfl=")) scene.numerics.cfl = std::stod(one.substr(13));
            if (one == "numerics.particles-per-cell=16") scene.numerics.particles_per_cell = 16;
        }
        return scene;
    };
    options.run = [&seen](const Scene& scene) {
        seen.push_back(scene);
        return result_of(scene, seen.size() == 2 ? 1.04 : 1, seen.size() == 2 ? 9 : 10);
    };
    return options;
}

TEST(Robustness, DisturbancesHaveUniqueNames) {
    std::set<std::string> names{"base"};
    for (const Disturbance& one : disturbances()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
    for (const char* name : {"shifted", "turned-30", "turned-45", "turned-90", "rough", "particles-16", "cfl-0.95"})
        EXPECT_EQ(names.count(name), 1U) << name;
}

TEST(Robustness, ReportsChangesAndMarksThoseBeyondFivePercent) {
    std::vector<Scene> seen;
    RobustnessOptions options = options_of(seen);
    options.only = {"cfl-0.95", "cfl-0.8", "particles-1", "turned-90"};
    const auto rows = run_robustness(options);
    ASSERT_EQ(rows.size(), 4U) << "cfl-0.8 is the scene's own";
    EXPECT_EQ(seen.size(), 3U) << "particles-1 is refused";
    EXPECT_EQ(seen[1].numerics.cfl, 0.95);
    EXPECT_EQ(rows[0].statistics.depth.greatest, 2);
    EXPECT_EQ(rows[0].statistics.covered_area, 24 * 16 * 25);
    EXPECT_NEAR(rows[0].statistics.final_depth_fraction, 0.8, 1e-12);
    const auto change = [&](std::size_t row, const char* key) -> double {
        for (const RunStatistic& statistic : k_run_statistics)
            if (std::string(statistic.key) == key) return relative_change(rows, row, statistic).value_or(99);
        return 100;
    };
    EXPECT_NEAR(change(1, "max_depth_m"), 0.04, 1e-12);
    EXPECT_NEAR(change(1, "max_velocity_p99_ms"), -0.1, 1e-12);
    EXPECT_EQ(change(2, "max_depth_m"), 99) << "refused";
    EXPECT_EQ(change(3, "covered_area_m2"), 0);
    const std::string table = robustness_table(rows);
    EXPECT_NE(table.find("-10.0 %*"), std::string::npos) << table;
    EXPECT_NE(table.find("+4.0 %  "), std::string::npos) << table;
    EXPECT_NE(table.find("maximum velocity       changes by -10 % at most (cfl-0.95); more than 5 % in 1 of 3"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("particles-1  not run: "), std::string::npos) << table;
    const std::string csv = robustness_csv(rows);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "disturbance,max_depth_m,max_depth_m_change,max_depth_p999_m,max_depth_p999_m_change,max_depth_p99_m,"
              "max_depth_p99_m_change,max_velocity_ms,max_velocity_ms_change,max_velocity_p999_ms,"
              "max_velocity_p999_ms_change,max_velocity_p99_ms,max_velocity_p99_ms_change,covered_area_m2,"
              "covered_area_m2_change,runout_m,runout_m_change,final_depth_fraction,final_depth_fraction_change,"
              "simulated_seconds,steps,particles,wall_seconds,state");
    std::set<std::ptrdiff_t> commas;
    std::size_t begin = 0;
    for (std::size_t end = csv.find('\n'); end != csv.npos; begin = end + 1, end = csv.find('\n', begin))
        commas.insert(std::count(csv.begin() + static_cast<std::ptrdiff_t>(begin),
                                 csv.begin() + static_cast<std::ptrdiff_t>(end), ','));
    EXPECT_EQ(commas.size(), 1U) << csv;
    const Json runs = Json::parse(robustness_json(rows, options, "a.ini"))["runs"];
    EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [](const Json& run) {
        return std::any_of(run.begin(), run.end(),
                           [](const Json& value) { return value.is_object() && value.value("marked", false); });
    }));
}

TEST(Robustness, DisturbsTheGroundAsSpecified) {
    std::vector<Scene> seen;
    RobustnessOptions options = options_of(seen);
    options.only = {"shifted", "turned-45", "rough"};
    run_robustness(options);
    ASSERT_EQ(seen.size(), 4U);
    EXPECT_EQ(seen[1].grid.columns, 23);
    EXPECT_GT(seen[2].grid.columns, 24);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < seen[3].terrain.values.size(); ++i) {
        const double noise = seen[3].terrain.values[i] - seen[0].terrain.values[i];
        sum += noise;
        squares += noise * noise;
    }
    const auto count = static_cast<double>(seen[3].terrain.values.size());
    EXPECT_NEAR(sum / count, 0, 0.02);  // four standard errors of 384 cells
    EXPECT_NEAR(std::sqrt(squares / count), 0.1, 0.015);
    std::vector<Scene> again;
    RobustnessOptions same = options_of(again);
    same.only = {"rough"};
    run_robustness(same);
    EXPECT_EQ(again[1].terrain.values, seen[3].terrain.values);
    same.seed = 2;
    run_robustness(same);
    EXPECT_NE(again[3].terrain.values, seen[3].terrain.values);
}

TEST(Robustness, ARunThatCannotStartStopsNoOther) {
    std::vector<Scene> seen;
    RobustnessOptions options = options_of(seen);
    options.only = {"shifted", "turned-30"};
    const auto run = options.run;
    std::size_t refused = 2;
    options.run = [&](const Scene& scene) {
        RunResult result = run(scene);
        if (seen.size() == refused) throw Error(ErrorKind::input, Problem{"has no data", "terrain.dtm", "", "", ""});
        return result;
    };
    const auto rows = run_robustness(options);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_NE(rows[1].refusal.find("has no data"), std::string::npos);
    EXPECT_TRUE(rows[2].refusal.empty());
    seen.clear();
    refused = 1;
    EXPECT_THROW(run_robustness(options), Error) << "the scene as it is";
}

TEST(Robustness, AStoppedRunGivesNoRow) {
    std::vector<Scene> seen;
    RobustnessOptions options = options_of(seen);
    const auto run = options.run;
    options.run = [&](const Scene& scene) {
        RunResult result = run(scene);
        if (seen.size() == 3) result.stop_reason = StopReason::requested;
        return result;
    };
    EXPECT_EQ(run_robustness(options).size(), 2U);
}

}  // namespace
}  // namespace frana::bench
