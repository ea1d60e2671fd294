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
                                         "--out",   "ranked", "--size",    "800x600"};
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

}  // namespace
}  // namespace frana::test
