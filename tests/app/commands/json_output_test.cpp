// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using Document = TinyScene;

TEST_F(Document, OfCheckSaysWhatWouldRun) {
    write_scene(k_numbers_only);
    const Outcome outcome = succeeded(frana({"check", "scene.ini", "--json"}));
    const Json json = parse_json(outcome.out);
    EXPECT_EQ(json.at("program"), "frana");
    EXPECT_EQ(json.at("command"), "check");
    EXPECT_EQ(json.at("exit_code"), 0);
    EXPECT_EQ(json.at("scene"), path("scene.ini"));
    EXPECT_EQ(json.at("inputs").at(0).at("role"), "DTM");
    EXPECT_NE(json.at("inputs").at(0).at("crs").get<std::string>().find("UTM zone 32N"), std::string::npos);
    EXPECT_EQ(json.at("grid").at("columns"), k_columns);
    EXPECT_EQ(json.at("grid").at("cell_size_m"), k_cell);
    EXPECT_EQ(json.at("release").at("area_m2"), 2000);
    EXPECT_GT(json.at("run").at("particles"), 0);
    EXPECT_GT(json.at("run").at("memory_bytes"), 0);
    EXPECT_FALSE(json.at("result").at("exists"));
    EXPECT_TRUE(json.at("warnings").is_array());
}

TEST_F(Document, OfRunHasTheSummary) {
    write_scene(k_numbers_only);
    const Outcome outcome =
        succeeded(frana({"run", "scene.ini", "--out", "result", "--json", "--quiet", "--progress", "json"}));
    const Json json = parse_json(outcome.out);
    EXPECT_EQ(json.at("exit_code"), 0);
    EXPECT_EQ(json.at("finished"), true);
    EXPECT_EQ(json.at("result"), path("result"));
    EXPECT_EQ(json.at("summary"), parse_json(read_text(path("result/summary.json"))));
    const auto files = json.at("files").get<std::vector<std::string>>();
    EXPECT_NE(std::find(files.begin(), files.end(), "max_depth.tif"), files.end());

    // Progress: a document in each line of stderr.
    std::istringstream lines(outcome.err);
    double fraction = -1;
    std::string phase;
    for (std::string line; std::getline(lines, line);) {
        const Json progress = parse_json(line);
        phase = progress.at("phase").get<std::string>();
        if (phase != "computing") continue;
        EXPECT_GE(progress.at("fraction").get<double>(), fraction);
        fraction = progress.at("fraction").get<double>();
        EXPECT_LE(fraction, 1);
        EXPECT_NEAR(progress.at("simulated_s").get<double>(), fraction * progress.at("end_s").get<double>(), 1e-9);
        EXPECT_TRUE(progress.contains("seconds_left") && progress.contains("step") && progress.contains("particles"));
    }
    EXPECT_GE(fraction, 0);
    EXPECT_EQ(phase, "writing");
    refusal_of(frana({"run", "scene.ini", "--progress", "xml"}));
}

TEST_F(Document, ErrorsAreInPartsAndStayOnStderr) {
    write_scene("[numerics]\ncfl = 3\nschem = auto\n" + k_numbers_only);
    for (const char* command : {"check", "run", "converge"}) {
        const Outcome outcome = refusal_of(frana({command, "scene.ini", "--json"}));
        const Json json = parse_json(outcome.out);
        EXPECT_EQ(json.at("command"), command);
        EXPECT_EQ(json.at("exit_code"), 2);
        ASSERT_EQ(json.at("errors").size(), 2U) << outcome.out;
        const Json& cfl = json.at("errors").at(0);
        EXPECT_EQ(cfl.at("file"), "scene.ini");
        EXPECT_EQ(cfl.at("key"), "numerics.cfl");
        EXPECT_EQ(cfl.at("value"), "3");
        EXPECT_EQ(cfl.at("limit"), "greater than 0, at most 1");
        EXPECT_TRUE(cfl.at("option").is_null());
        EXPECT_NE(outcome.err.find(cfl.at("message").get<std::string>()), std::string::npos) << outcome.err;
        const Json& scheme = json.at("errors").at(1);
        EXPECT_EQ(scheme.at("key"), "numerics.schem");
        EXPECT_EQ(scheme.at("remedy"), "Did you mean numerics.scheme?");
    }
    const Json option = parse_json(frana({"run", "scene.ini", "--json", "--threads", "0"}).out).at("errors").at(0);
    EXPECT_EQ(option.at("option"), "--threads");
    EXPECT_EQ(option.at("value"), "0");
    const Json set = parse_json(frana({"check", "scene.ini", "--json", "--set", "time.end=x"}).out);
    bool found = false;
    for (const Json& one : set.at("errors"))
        found = found || (one.at("option") == "--set" && one.at("key") == "time.end" && one.at("file").is_null());
    EXPECT_TRUE(found) << set.dump(1);
    EXPECT_EQ(frana({"check", "scene.ini"}).out, "");  // only where it was asked for
}

TEST_F(Document, OfCompare) {
    write_scene(k_numbers_only);
    ran("a");
    const std::string trace = "a/extent.gpkg|layer=trace";
    const std::vector<std::string> one{"compare", "a", "--observed", trace, "--out", "scores", "--size", "640x480"};
    std::vector<std::string> with_json = one;
    with_json.push_back("--json");
    const Json json = parse_json(frana(with_json).out);
    EXPECT_EQ(json.at("comparison").at("jaccard"), 1);
    for (const Json& file : json.at("files"))
        EXPECT_TRUE(std::filesystem::exists(folder_ / file.get<std::string>())) << file;
    // For a person: a table with the same value, and the files.
    const Outcome table = frana(one);
    expect_words(table.out, {"Jaccard index", "\n  scores/comparison.png\n"});
    EXPECT_EQ(table.out.find('{'), std::string::npos);
}

TEST_F(Document, OfConverge) {
    write_scene(k_numbers_only);
    const Json study = parse_json(frana({"converge", "scene.ini", "--out", "levels", "--quiet", "--json"}).out);
    EXPECT_EQ(study.at("levels").size(), 3U);
    EXPECT_EQ(study.at("levels").at(2).at("cell_size_m"), k_cell);
    EXPECT_TRUE(study.at("convergence").at("statistics").is_object());
}

}  // namespace
}  // namespace frana::test
