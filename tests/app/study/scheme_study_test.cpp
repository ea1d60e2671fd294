// SPDX-License-Identifier: Apache-2.0
// The scheme of a study's members, and its check by the other one.
#include "gis/raster/raster_out.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

// The check's runs are those of `frana run` with the member's values and the other scheme; all files tell the scheme.
TEST_F(Ensemble, TwoMembersAreComputedAgainByTheOtherScheme) {
    write_study("samples = 6\nscheme = finite-volume\n", k_two_keys);
    succeeded(run({"--threads", "1"}));
    const Json summary = parse_json(read_text(path("out/summary.json"))), check = summary["scheme_check"];
    EXPECT_EQ(summary["scheme"], "finite-volume");
    EXPECT_EQ(check["scheme"], "default");
    EXPECT_TRUE(check["refused"].is_null()) << check;
    ASSERT_EQ(check["members"].size(), 2U) << check;
    EXPECT_EQ(check["members"][0]["chosen"], "median");
    EXPECT_EQ(check["members"][1]["chosen"], "farthest");
    const Rows rows = members();
    double most = 0;
    for (const Json& one : check["members"]) {
        for (const char* figure : {"runout_m", "covered_area_m2"})
            most = std::max(most, std::abs(one[figure]["difference"].get<double>()));
        const auto& row = rows.at(one["member"].get<std::size_t>());
        EXPECT_EQ(one["runout_m"]["members_scheme"], std::stod(row.at("runout_m")));
        for (const auto& other : rows)
            EXPECT_TRUE(one["chosen"] == "median" || std::stod(other.at("runout_m")) <= std::stod(row.at("runout_m")));
        std::vector<std::string> arguments{"run", "scene.ini", "--out", "alone", "--overwrite", "--quiet"};
        for (const auto& [key, value] : row)
            if (key.find('.') != std::string::npos) arguments.insert(arguments.end(), {"--set", key + "=" + value});
        succeeded(frana(arguments));
        const std::string alone = read_text(path("alone/summary.json"));
        EXPECT_EQ(one["runout_m"]["other_scheme"], json_number(alone, "runout.horizontal_m"));
        EXPECT_EQ(one["max_depth_m"]["other_scheme"], json_number(alone, "max_depth_m"));
        EXPECT_NE(one["max_depth_m"]["difference"], 0);
        EXPECT_LT(std::abs(one["covered_area_m2"]["difference"].get<double>()), 0.3) << one;
    }
    EXPECT_EQ(summary["warnings"].dump().find("% from particles: take study.scheme = default") != std::string::npos,
              most > 0.1)
        << most;
    EXPECT_EQ(
        gis::read_raster_text(path("out/hit_count.tif")).metadata["DOUBTS"].find("from particles") != std::string::npos,
        most > 0.1);
    EXPECT_NE(read_text(path("out/study.ini")).find("\nscheme = finite-volume\n"), std::string::npos);
    EXPECT_NE(read_text(path("out/scene.ini")).find("\nscheme = finite-volume\n"), std::string::npos);
    EXPECT_NE(read_text(path("out/hit_count.tif")).find("name=\"SCHEME\""), std::string::npos);
    EXPECT_NE(read_text(path("out/log.txt")).find("Scheme of the runs: finite-volume\n"), std::string::npos);
    succeeded(frana({"ensemble", "study.ini", "--out", "two", "--threads", "2", "--quiet"}));
    expect_same("out", "two");
}

TEST_F(Ensemble, WhatTheOtherSchemeCannotComputeIsTold) {
    write_scene(
        "stop-when-still = off\n[numerics]\nflight = on\n[output]\nmaps = off\nanimation = off\nlanguage = it\n");
    write_study("samples = 2\n", k_two_keys);
    succeeded(run());
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["scheme"], "default");
    EXPECT_EQ(summary["scheme_check"]["scheme"], "finite-volume");
    EXPECT_NE(summary["scheme_check"]["refused"].get<std::string>().find("numerics.flight"), std::string::npos);
    EXPECT_TRUE(summary["scheme_check"]["members"].empty());
    const std::string page = read_text(path("out/report.html"));
    const std::size_t told = page.find("Non verificato con lo schema finite-volume");
    EXPECT_LT(told, page.find("<h2 id=\"maps\"")) << "on the first page";
}

TEST_F(Ensemble, TheSchemeIsGivenOnce) {
    write_study("samples = 2\nscheme = finite-volume\n", "[set]\nnumerics.scheme = default\n" + k_two_keys);
    refusal_of(run(), {"study.ini: set.numerics.scheme: is also given by scheme"});
    write_study("samples = 4\n", "[vary]\nnumerics.scheme = choice(default: 1, finite-volume: 1)\n");
    succeeded(run());
    const Json varied = parse_json(read_text(path("out/summary.json")));
    EXPECT_TRUE(varied["scheme"].is_null());
    EXPECT_FALSE(varied.contains("scheme_check"));
}

}  // namespace
}  // namespace frana::test
