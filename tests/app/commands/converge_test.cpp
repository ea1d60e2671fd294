// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

using ConvergeCommand = TinyScene;

TEST_F(ConvergeCommand, ReportsLevelsAndLaterRunsReportThem) {
    write_scene("[output]\nmaps = off\nanimation = off\nreport = off\n");
    const Outcome study = succeeded(frana({"converge", "scene.ini", "--out", "result-convergence", "--quiet"}));
    EXPECT_NE(study.out.find("Covered area"), std::string::npos) << study.out;
    for (const char* name : {"convergence.csv", "convergence.json", "convergence.png", "uncertainty.tif",
                             "uncertainty.qml", "uncertainty.sld"}) {
        EXPECT_TRUE(fs::exists(path("result-convergence/" + std::string(name)))) << name;
    }
    // A run of the scene still moves when its end is reached, and so does every level.
    const std::string json = read_text(path("result-convergence/convergence.json"));
    EXPECT_TRUE(json_lists(json, "warnings", "cells of 5 m: the flow still moves")) << json;
    EXPECT_TRUE(json_lists(json, "warnings", "cells of 20 m: ")) << json;
    const std::string csv = read_text(path("result-convergence/convergence.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);  // a header and three levels
    expect_words(csv, {"max_depth_m,max_depth_p999_m,", "max_velocity_ms,max_velocity_p999_ms,"});

    const Outcome same = frana({"run", "scene.ini", "--out", "result"});
    EXPECT_NE(same.err.find("estimated error"), std::string::npos) << same.err;
    // Another material: the estimate belongs to another scene.
    const Outcome other =
        succeeded(frana({"run", "scene.ini", "--out", "result", "--overwrite", "--set", "material.density=1900"}));
    EXPECT_EQ(other.err.find("estimated error"), std::string::npos) << other.err;
}

// Errors of a level are its distance from the finest one and the error of that; times are of the processor.
TEST_F(ConvergeCommand, TellsErrorAndTimeOfEachLevelOfBothSchemes) {
    write_scene(k_numbers_only);
    const Outcome study =
        succeeded(frana({"converge", "scene.ini", "--out", "both", "--schemes", "--quiet", "--json"}));
    const Json json = parse_json(study.out), rows = json["levels"], convergence = json["convergence"];
    ASSERT_EQ(rows.size(), 6U);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Json &row = rows[i], &finest = rows[i / 3 * 3 + 2];
        EXPECT_EQ(row["scheme"], i < 3 ? "default" : "finite-volume");
        EXPECT_GT(row["cpu_seconds"].get<double>(), 0);
        EXPECT_EQ(row["particles"].get<int>() > 0, i < 3);
        const Json& statistics = i < 3 ? convergence["statistics"] : convergence["other_scheme"]["statistics"];
        const double own = row["max_depth_m"], best = finest["max_depth_m"];
        EXPECT_EQ(statistics["max_depth_m"]["finest"], best);
        if (!row["error_max_depth_m"].is_number()) continue;  // not converged
        EXPECT_NEAR(row["error_max_depth_m"].get<double>(),
                    (std::abs(own - best) + statistics["max_depth_m"]["estimated_error"].get<double>()) / best, 1e-6);
        EXPECT_GE(row["error"].get<double>(), row["error_max_depth_m"].get<double>());
    }
    EXPECT_TRUE(json.contains("least_time"));
    refusal_of(frana({"converge", "scene.ini", "--out", "fly", "--schemes", "--set", "numerics.flight=on"}));
    const Outcome printed = frana({"converge", "scene.ini", "--out", "both", "--schemes", "--quiet", "--overwrite"});
    expect_words(printed.out, {"within 5 %", "on the finest cells the schemes differ by at most", "s of CPU"});
}

// The levels' own cell sizes count in place of the one given, which is the finest.
TEST_F(ConvergeCommand, TheFinestCellsMayBeGiven) {
    write_scene(k_numbers_only);
    succeeded(frana(
        {"converge", "scene.ini", "--out", "given", "--quiet", "--set", "terrain.cell-size=4", "--set", "time.end=3"}));
    EXPECT_EQ(json_number(read_text(path("given/convergence.json")), "finest_cell_size_m"), 4);
}

TEST_F(ConvergeCommand, RefusesTwoLevelsAndAnExistingStudy) {
    write_scene("");
    refusal_of(frana({"converge", "scene.ini", "--levels", "2"}));
    fs::create_directory(path("study"));
    std::ofstream(path("study/convergence.json")) << "{}\n";
    refusal_of(frana({"converge", "scene.ini", "--out", "study"}), {"--overwrite"});
}

}  // namespace
}  // namespace frana::test
