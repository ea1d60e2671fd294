// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>

#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using Compare = TinyScene;

TEST_F(Compare, AForeignRasterAgainstAnOutline) {
    // Depth 1 m in columns 4 to 13 of rows 10 to 19: 50 m x 50 m from (20, 50) to (70, 100).
    write_dtm([](int row, int column) { return row >= 10 && row < 20 && column >= 4 && column < 14 ? 1.0 : -9999.0; },
              true, "depth.asc");
    write_polygon("scar", {{45, 50}, {95, 50}, {95, 100}, {45, 100}});  // half of it, and as much outside
    const Outcome outcome = succeeded(frana({"compare", "--json", "depth.asc", "--scar", "scar.geojson", "--threshold",
                                             "0.5", "--out", "scores", "--size", "640x480"}));
    EXPECT_EQ(parse_json(outcome.out).at("comparison"), parse_json(read_text(path("scores/comparison.json"))));
    EXPECT_EQ(json_number(outcome.out, "hit_m2"), 1250);
    EXPECT_EQ(json_number(outcome.out, "false_alarm_m2"), 1250);
    EXPECT_EQ(json_number(outcome.out, "miss_m2"), 1250);
    EXPECT_EQ(json_number(outcome.out, "area_difference_percent"), 0);
    EXPECT_EQ(json_number(outcome.out, "threshold_m"), 0.5);
    EXPECT_NEAR(json_number(outcome.out, "jaccard"), 1.0 / 3, 1e-15);  // one rounding
    EXPECT_TRUE(json_value(outcome.out, "runout_difference_m").is_null());
    EXPECT_TRUE(std::filesystem::exists(path("scores/comparison.tif")));
    EXPECT_TRUE(std::filesystem::exists(path("scores/comparison.png")));
}

TEST_F(Compare, AScarBeyondTheGridCountsAsMissed) {
    write_dtm([](int, int) { return 1.0; }, true, "depth.asc");
    write_polygon("scar", {{200, 0}, {400, 0}, {400, 150}, {200, 150}});  // 100 m on the grid, 100 m beyond
    const Outcome outcome = succeeded(
        frana({"compare", "--json", "depth.asc", "--scar", "scar.geojson", "--out", "scores", "--size", "640x480"}));
    EXPECT_EQ(json_number(outcome.out, "observed_area_m2"), 200 * 150);
    EXPECT_EQ(json_number(outcome.out, "miss_m2"), 100 * 150);
    EXPECT_NE(outcome.err.find("beyond the rasters"), std::string::npos) << outcome.err;
    EXPECT_EQ(parse_json(read_text(path("scores/comparison.json"))).at("warnings").size(), 1U);
}

TEST_F(Compare, WhatLimitsTheUseOfAResultIsToldWithItsScores) {
    write_polygon("scar", {{20, 20}, {250, 20}, {250, 130}, {20, 130}});
    ran();
    const Outcome outcome = succeeded(frana({"compare", "result", "--observed", "scar.geojson", "--size", "640x480"}));
    expect_words(outcome.err, {"the flow still moves"});
    expect_words(read_text(path("result/comparison.json")), {"the flow still moves"});
}

// The comparison's raster has the whole outline, and so other cells than the run's.
TEST_F(Compare, ARunWhoseOutlineReachesBeyondItsGroundIsFinished) {
    write_polygon("scar", {{20, 20}, {250, 20}, {250, 130}, {20, 130}});
    write_scene(
        "[terrain]\nbounds = 527000 5094000 527150 5094150\n[output]\nanimation = off\nframes = off\n"
        "[observed]\nperimeter = scar.geojson\n");
    ran();
    EXPECT_TRUE(json_lists(read_text(path("result/summary.json")), "warnings", "beyond the rasters"));
    for (const char* file : {"result/comparison.png", "result/report.html"})
        EXPECT_TRUE(std::filesystem::exists(path(file))) << file;
    EXPECT_EQ(json_number(read_text(path("result/comparison.json")), "observed_area_m2"), 230 * 110);
    succeeded(frana({"render", "result", "--map", "comparison", "--out", "again", "--size", "640x480"}));
}

TEST_F(Compare, AResultAgainstAnOutlineInAnotherCrs) {
    write_scene(k_numbers_only);
    ran();
    // Around the release, in degrees: a few hundredths of a square kilometre, any overlap shows that the transformation
    // works.
    write("scar.geojson",
          R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[)"
          R"([9.3485, 45.9995], [9.3525, 45.9995], [9.3525, 46.0025], [9.3485, 46.0025], [9.3485, 45.9995]]]}})");
    const Outcome outcome =
        succeeded(frana({"compare", "--json", "result", "--scar", "scar.geojson", "--size", "640x480"}));
    EXPECT_GT(json_number(outcome.out, "hit_m2"), 0);
    EXPECT_EQ(json_number(outcome.out, "threshold_m"), 0.1);  // the result's own trace threshold
    EXPECT_TRUE(std::filesystem::exists(path("result/comparison.json")));
}

TEST_F(Compare, ClassesDifferInLightnessForPrintsWithoutColours) {
    write_dtm([](int, int) { return 1.0; }, true, "depth.asc");
    write_polygon("scar", {{200, 0}, {280, 0}, {280, 150}, {200, 150}});
    succeeded(
        frana({"compare", "--json", "depth.asc", "--scar", "scar.geojson", "--out", "scores", "--size", "640x480"}));
    const std::vector<gis::NamedClass> classes = gis::read_raster_text(path("scores/comparison.tif")).classes;
    ASSERT_EQ(classes.size(), 3U);
    std::vector<double> tones;  // Rec. 601 luma, of 255
    for (const gis::NamedClass& one : classes)
        tones.push_back(0.299 * one.colour.r + 0.587 * one.colour.g + 0.114 * one.colour.b);
    std::sort(tones.begin(), tones.end());
    // As different as neighbours in a scale of six classes.
    EXPECT_GT(tones[1] - tones[0], 40);
    EXPECT_GT(tones[2] - tones[1], 40);
}

TEST_F(Compare, MissingScarFile) {
    write_dtm([](int, int) { return 1.0; }, true, "depth.asc");
    refusal_of(frana({"compare", "--json", "depth.asc", "--scar", "none.shp", "--out", "scores"}), {"none.shp"});
    EXPECT_FALSE(std::filesystem::exists(path("scores")));
}

/// Depth 1 m on a square of 50 m, from (20, 50) to (70, 100), in depth.asc.
class CompareSquare : public TinyScene {
  protected:
    CompareSquare() {
        write_dtm(
            [](int row, int column) { return row >= 10 && row < 20 && column >= 4 && column < 14 ? 1.0 : -9999.0; },
            true, "depth.asc");
    }
    [[nodiscard]] Outcome compare(std::vector<std::string> more) const {
        return frana(
            with_more({"compare", "--json", "depth.asc", "--overwrite", "--out", "scores", "--size", "640x480"}, more));
    }
};

TEST_F(CompareSquare, OutlineDistancesOfASquareShiftedByHalf) {
    write_polygon("scar", {{45, 50}, {95, 50}, {95, 100}, {45, 100}});
    const Outcome outcome = succeeded(compare({"--scar", "scar.geojson"}));
    // Squares of 50 m, 25 m apart. For each outline: the far side is 25 m away (50 m of it); of the two sides along the
    // shift, the half covered by the other square is 0 m away, the other half 0 to 25, at 2.5, 7.5 ... 22.5 m (samples
    // of 5 m); the near side is inside the other square, 25 m from its edge except near the corners: min(25, distance
    // to the sides) = 2.5, 7.5, 12.5, 17.5, 22.5 and back.
    const double along = 2 * (2.5 + 7.5 + 12.5 + 17.5 + 22.5);  // two sides; the covered halves add nothing
    const double near = 2 * (2.5 + 7.5 + 12.5 + 17.5 + 22.5);
    EXPECT_NEAR(json_number(outcome.out, "mean_m"), (10 * 25 + along + near) / 40, 1e-9);
    EXPECT_NEAR(json_number(outcome.out, "hausdorff_m"), 25, 1e-9);
    EXPECT_NEAR(json_number(outcome.out, "percentile_95_m"), 25, 1e-9);
    // The curve: one row for 0 and for 0.01 to 0.7; every one the same, as all depths are 1 m.
    const std::string curve = read_text(path("scores/comparison_curve.csv"));
    EXPECT_EQ(std::count(curve.begin(), curve.end(), '\n'), 1 + 1 + 12);
    EXPECT_EQ(curve.rfind("threshold_m,observed_area_m2", 0), 0U);
}

TEST_F(CompareSquare, AFrontAndATip) {
    // A front 15 m beyond the eastern edge, and a point 10 m inside it.
    write_features("front", {{"LineString", {{85, 60}, {85, 90}}, named("f")}});
    const Outcome front = succeeded(compare({"--scar", "front.geojson"}));
    EXPECT_NEAR(json_number(front.out, "mean_signed_m"), -15, 1e-9);
    EXPECT_NEAR(json_number(front.out, "hausdorff_m"), 15, 1e-9);
    EXPECT_EQ(json_number(front.out, "reached_percent"), 0);
    EXPECT_TRUE(json_value(front.out, "jaccard").is_null());
    EXPECT_FALSE(std::filesystem::exists(path("scores/comparison.tif")));
    write_features("tip", {{"Point", {{60, 75}}, named("f")}});
    const Outcome tip = succeeded(compare({"--scar", "tip.geojson"}));
    EXPECT_NEAR(json_number(tip.out, "distance_m"), 10, 1e-9);
}

TEST_F(CompareSquare, AnOpenLineThatCrossesTheEdgeIsHalfReached) {
    write_features("front", {{"LineString", {{50, 75}, {90, 75}}, named("f")}});
    const Outcome outcome = succeeded(compare({"--scar", "front.geojson"}));
    EXPECT_NEAR(json_number(outcome.out, "reached_percent"), 50, 1e-9);
    EXPECT_NEAR(json_number(outcome.out, "mean_signed_m"), 0, 1e-9);
    // Samples every 5 m: 2.5, 7.5, 12.5 and 17.5 m on either side.
    EXPECT_NEAR(json_number(outcome.out, "mean_m"), 10, 1e-9);
}

TEST_F(CompareSquare, OneResultIsComparedWithOneSurvey) {
    for (const std::vector<std::string>& more : {std::vector<std::string>{"depth.asc", "--scar", "scar.geojson"},
                                                 {"--scar", "scar.geojson", "--observed", "other.geojson"}}) {
        refusal_of(frana(with_more({"compare", "depth.asc"}, more)), {"`frana calibrate` finds"});
    }
}

TEST_F(Compare, AnotherSurveyReplacesNoComparisonUnasked) {
    write_polygon("first", {{20, 40}, {90, 40}, {90, 110}, {20, 110}});
    write_polygon("second", {{20, 40}, {60, 40}, {60, 110}, {20, 110}});
    write_scene(k_numbers_only + "[observed]\nperimeter = first.geojson\n");
    ran("a");
    const std::string before = read_text(path("a/comparison.json"));
    std::vector<std::string> words{"compare", "a", "--observed", "second.geojson", "--size", "640x480"};
    refusal_of(frana(words), {"contains the comparison with another survey"});
    EXPECT_EQ(read_text(path("a/comparison.json")), before);
    succeeded(frana({"compare", "a", "--observed", "first.geojson", "--size", "640x480"}));
    words.insert(words.end(), {"--out", "b"});
    succeeded(frana(words));
    EXPECT_EQ(read_text(path("a/comparison.json")).find("second"), std::string::npos);
    words.resize(words.size() - 2);
    words.emplace_back("--overwrite");
    const Outcome replaced = succeeded(frana(words));
    EXPECT_NE(read_text(path("a/comparison.json")).find("second"), std::string::npos);
    // Both areas are known: the difference has their sign.
    const Json scores = parse_json(read_text(path("a/comparison.json")));
    const bool larger = scores.at("simulated_area_m2") > scores.at("observed_area_m2");
    const std::size_t size = replaced.out.find(" % in size");
    ASSERT_NE(size, std::string::npos) << replaced.out;
    const std::string number = replaced.out.substr(replaced.out.rfind(' ', size - 1) + 1, 1);
    EXPECT_EQ(number, larger ? "+" : "-") << replaced.out;
}

TEST_F(Compare, ADepositAgainstAnElevationDifference) {
    write_scene(k_numbers_only);
    ran();
    // The survey is half of the result's own change: at this low threshold both rise on the same cells.
    const Raster left = gis::read_result_raster(path("result/final_depth.tif")),
                 gone = gis::read_result_raster(path("result/release.tif"));
    const auto or_zero = [](const Raster& raster, int row, int column) {
        return raster.has_data(row, column) ? raster.at(row, column) : 0.0;
    };
    write_dtm([&](int row, int column) { return (or_zero(left, row, column) - or_zero(gone, row, column)) / 2; }, true,
              "change.asc");
    const Outcome outcome = succeeded(
        frana({"compare", "--json", "result", "--deposit", "change.asc", "--threshold", "0.004", "--out", "d"}));
    EXPECT_EQ(json_number(outcome.out, "deposit.jaccard"), 1);
    const auto depth_error = [&](const std::string& key) {
        return json_number(outcome.out, "deposit.depth_error." + key);
    };
    EXPECT_NEAR(depth_error("simulated_volume_m3"), 2 * depth_error("observed_volume_m3"), 0.1);
    EXPECT_NEAR(depth_error("correlation"), 1, 1e-6);
    EXPECT_NEAR(depth_error("simulated_lowered_m3"), 2 * depth_error("observed_lowered_m3"), 0.1);
    EXPECT_GT(depth_error("observed_lowered_m3"), 0);
    EXPECT_NEAR(depth_error("bias_m"), depth_error("mean_absolute_error_m"), 1e-6);
}

TEST_F(Compare, AResultAgainstItsOwnTraceIsPerfectAlongThePathToo) {
    write_scene(k_numbers_only);
    ran();
    const Outcome outcome = succeeded(
        frana({"compare", "--json", "result", "--scar", "result/extent.gpkg|layer=trace", "--size", "640x480"}));
    EXPECT_EQ(json_number(outcome.out, "jaccard"), 1);
    EXPECT_EQ(json_number(outcome.out, "runout_difference_m"), 0);
    EXPECT_EQ(json_number(outcome.out, "difference_m"), 0);
    EXPECT_NEAR(json_number(outcome.out, "hausdorff_m"), 0, 1e-8);  // coordinates of 5e6 m in double
}

}  // namespace
}  // namespace frana::test
