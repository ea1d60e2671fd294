// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using Ranking = TinyScene;

TEST_F(Ranking, ShowsWhatVariedBetweenTheResults) {
    write_scene(k_numbers_only);
    const auto run = [&](const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", "scene.ini", "--out", out, "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        ASSERT_EQ(frana(words).exit_code, 0);
    };
    run("a", {"--set", "material.friction-coefficient=0.1", "--set", "output.title=First"});
    run("deep/er/b", {"--set", "material.friction-coefficient=0.2", "--set", "release.thickness=3"});
    const std::vector<std::string> words{"compare", "a",      "deep/er/b", "--observed", "a/extent.gpkg|layer=trace",
                                         "--out",   "ranked", "--size",    "640x480"};
    const Outcome table = frana(words);
    ASSERT_EQ(table.exit_code, 0) << table.err;
    EXPECT_NE(table.out.find("material.friction-coefficient"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("\n  ranked/ranking.csv\n"), std::string::npos) << table.out;
    std::vector<std::string> with_json = words;
    with_json.push_back("--json");
    const Json rows = parse_json(frana(with_json).out).at("ranking");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows.at(0).at("simulated"), "a");
    EXPECT_EQ(rows.at(0).at("material.friction-coefficient"), 0.1);
    EXPECT_EQ(rows.at(1).at("material.friction-coefficient"), 0.2);
    EXPECT_EQ(rows.at(1).at("release.thickness"), 3);
    // The title changes no score; the DTM is the same file, though the results name it differently.
    EXPECT_FALSE(rows.at(0).contains("output.title"));
    EXPECT_FALSE(rows.at(0).contains("terrain.dtm"));
    EXPECT_FALSE(rows.at(0).contains("material.density"));
}

TEST_F(Ranking, IsBesideTheFirstResultWhereverItIsAskedFor) {
    write_scene(k_numbers_only);
    for (const char* out : {"results/a", "results/b"})
        ASSERT_EQ(frana({"run", "scene.ini", "--out", out, "--quiet"}).exit_code, 0);
    const Outcome table = frana(
        {"compare", "results/a", "results/b", "--observed", "results/a/extent.gpkg|layer=trace", "--size", "640x480"});
    ASSERT_EQ(table.exit_code, 0) << table.err;
    EXPECT_NE(table.out.find("\n  results/ranking.csv\n"), std::string::npos) << table.out;
    EXPECT_TRUE(std::filesystem::exists(path("results/ranking.csv")));
    EXPECT_FALSE(std::filesystem::exists(path("ranking.csv")));
}

TEST_F(Ranking, AnotherSurveyReplacesNoComparisonUnasked) {
    write_polygon("first", {{20, 40}, {90, 40}, {90, 110}, {20, 110}});
    write_polygon("second", {{20, 40}, {60, 40}, {60, 110}, {20, 110}});
    write_scene(k_numbers_only + "[observed]\nperimeter = first.geojson\n");
    ASSERT_EQ(frana({"run", "scene.ini", "--out", "a", "--quiet"}).exit_code, 0);
    const std::string before = read_text(path("a/comparison.json"));
    std::vector<std::string> words{"compare", "a", "--observed", "second.geojson", "--size", "640x480"};
    const Outcome refused = frana(words);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("contains the comparison with another survey"), std::string::npos) << refused.err;
    EXPECT_EQ(read_text(path("a/comparison.json")), before);
    EXPECT_EQ(frana({"compare", "a", "--observed", "first.geojson", "--size", "640x480"}).exit_code, 0);
    words.insert(words.end(), {"--out", "b"});
    EXPECT_EQ(frana(words).exit_code, 0);
    EXPECT_EQ(read_text(path("a/comparison.json")).find("second"), std::string::npos);
    words.resize(words.size() - 2);
    words.emplace_back("--overwrite");
    const Outcome replaced = frana(words);
    EXPECT_EQ(replaced.exit_code, 0) << replaced.err;
    EXPECT_NE(read_text(path("a/comparison.json")).find("second"), std::string::npos);
    // Both areas are known: the difference has their sign.
    const Json scores = parse_json(read_text(path("a/comparison.json")));
    const bool larger = scores.at("simulated_area_m2") > scores.at("observed_area_m2");
    const std::size_t size = replaced.out.find(" % in size");
    ASSERT_NE(size, std::string::npos) << replaced.out;
    const std::string number = replaced.out.substr(replaced.out.rfind(' ', size - 1) + 1, 1);
    EXPECT_EQ(number, larger ? "+" : "-") << replaced.out;
}

}  // namespace
}  // namespace frana::test
