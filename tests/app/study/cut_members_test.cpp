// SPDX-License-Identifier: Apache-2.0
// Members that time.end cuts, and what else no figure may hide.
#include <nlohmann/json.hpp>

#include "gis/access/table_in.h"
#include "gis/raster/raster_out.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// Eighteen creeks were stopped by their momentum with half of their volume moving, and no word of it.
TEST_F(Ensemble, WhateverStopsARunThatMovesIsTold) {
    for (const std::string key : {"time.end", "time.stop-momentum"}) {
        const bool is_end = key == "time.end";
        const std::string set = key + (is_end ? "=3" : "=0.5"),
                          other = is_end ? "time.stop-momentum=0" : "time.end=300",
                          friction = is_end ? "material.friction-angle=18" : "material.friction-angle=32";
        for (const auto& [strict, code] : {std::pair("--strict", 3), {"--quiet", 0}})
            EXPECT_EQ(frana({"run", "scene.ini", "--out", "one", "--overwrite", strict, "--set", set, "--set", other,
                             "--set", friction})
                          .exit_code,
                      code)
                << key;
        EXPECT_NE(read_text(path("one/log.txt")).find("still moves when " + key + " ends the run"), std::string::npos);
        EXPECT_TRUE(gis::read_raster_text(path("one/max_depth.tif")).metadata.contains("LOWER_BOUND"));
    }
    // Nor has all settled that a loose limit calls so.
    EXPECT_EQ(frana({"run", "scene.ini", "--out", "loose", "--strict", "--set", "time.stop-change=0.5", "--set",
                     "time.end=300"})
                  .exit_code,
              3);
    EXPECT_NE(read_text(path("loose/log.txt")).find("still moves when time.stop-change ends the run"),
              std::string::npos);
    EXPECT_TRUE(gis::read_raster_text(path("loose/max_depth.tif")).metadata.contains("LOWER_BOUND"));
}

// A member that time.end cuts runs on, at most ten times as long: it is the run of the scene with that end, and comes
// to rest in place of being a bound.
TEST_F(Ensemble, MembersThatAreCutRunOnToTheirEnd) {
    write_study("samples = 4\n",
                "[set]\ntime.end = 12\ntime.stop-when-still = on\n[vary]\n"
                "material.friction-angle = uniform(16, 24)\n");
    succeeded(run());
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["run_troubles"]["cut"], 0);
    std::size_t longer = 0;
    for (const auto& row : members()) {
        longer += row.at("time.end") == "120" ? 1 : 0;
        const Outcome alone =
            succeeded(frana({"run", "scene.ini", "--out", "alone", "--overwrite", "--quiet", "--set",
                             "time.stop-when-still=on", "--set", "time.end=" + row.at("time.end"), "--set",
                             "material.friction-angle=" + row.at("material.friction-angle")}));
        const std::string text = read_text(path("alone/summary.json"));
        EXPECT_EQ(std::stod(row.at("covered_area_m2")), json_number(text, "covered_area_m2"));
        EXPECT_EQ(std::stod(row.at("runout_m")), json_number(text, "runout.horizontal_m"));
    }
    EXPECT_GT(longer, 0U);
    const auto metadata = gis::read_raster_text(path("out/probability_depth_0.1.tif")).metadata;
    EXPECT_EQ(metadata.at("VARIED"), "material.friction-angle");
    EXPECT_EQ(metadata.at("RUNS"), "4 of 4");
    EXPECT_FALSE(metadata.contains("LOWER_BOUND"));
    // A time.end that is varied is meant.
    write_study("samples = 4\n", "[vary]\ntime.end = uniform(2, 3)\n");
    succeeded(run({"--overwrite"}));
    for (const auto& row : members()) EXPECT_LE(std::stod(row.at("time.end")), 3);
    EXPECT_TRUE(gis::read_raster_text(path("out/probability_depth_0.1.tif")).metadata.contains("LOWER_BOUND"));
}

// A field of error has no place in a polynomial: 0 would say that it does nothing. A figure that is the same in all
// runs has nothing to explain.
TEST_F(Ensemble, AFieldOfErrorIsWhatThePolynomialsDoNotExplain) {
    write_study("samples = 40\n",
                "[set]\ntime.end = 6\n[vary]\nmaterial.friction-angle = uniform(10, 24)\n"
                "terrain.error = gaussian-field(0.3, 40)\n");
    succeeded(run());
    const gis::Table table = gis::read_table(path("out/sensitivity.csv"), "table");
    int fields = 0, rests = 0;
    for (const auto& row : table.rows) {
        EXPECT_NE(row[0], "volume_m3") << "the same in all runs";
        if (row[7] == "not explained") {
            ++fields;
            EXPECT_EQ(row[1], "terrain.error");
            EXPECT_TRUE(row[2].empty() && row[3].empty()) << row[2];
        } else if (row[1] == "not explained") {
            ++rests;
            EXPECT_NEAR(std::stod(row[2]), 1 - std::stod(row[8]), 1e-9);
        }
    }
    EXPECT_GT(fields, 0);
    EXPECT_GE(rests, fields);
    EXPECT_FALSE(fs::exists(path("out/sensitivity_terrain.error.tif")));
}

}  // namespace
}  // namespace frana::test
