// SPDX-License-Identifier: Apache-2.0
#include "tiny_scene.h"

namespace frana::test {
namespace {

using Compare = TinyScene;

TEST_F(Compare, AForeignRasterAgainstAnOutline) {
    // Depth 1 m in columns 4 to 13 of rows 10 to 19: 50 m x 50 m from (20, 50) to (70, 100).
    write_dtm([](int row,
                 int column) { return row >= 10 && row < 20 && column >= 4 && column < 14 ? 1.0 : -9999.0; },
              true, "depth.asc");
    write_polygon("scar", {{45, 50}, {95, 50}, {95, 100}, {45, 100}});  // half of it, and as much beside
    const Outcome outcome = frana({"compare", "depth.asc", "--scar", "scar.geojson", "--threshold", "0.5",
                                   "--out", "scores", "--size", "800x600"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, read_text(path("scores/comparison.json")));
    EXPECT_EQ(json_number(outcome.out, "hit_m2"), 1250);
    EXPECT_EQ(json_number(outcome.out, "false_alarm_m2"), 1250);
    EXPECT_EQ(json_number(outcome.out, "miss_m2"), 1250);
    EXPECT_EQ(json_number(outcome.out, "area_difference_percent"), 0);
    EXPECT_EQ(json_number(outcome.out, "threshold_m"), 0.5);
    EXPECT_NEAR(json_number(outcome.out, "jaccard"), 1.0 / 3, 1e-15);  // one rounding
    EXPECT_NE(outcome.out.find("\"runout_difference_m\": null"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(path("scores/comparison.tif")));
    EXPECT_TRUE(std::filesystem::exists(path("scores/comparison.png")));
}

TEST_F(Compare, AScarBeyondTheGridCountsAsMissed) {
    write_dtm([](int, int) { return 1.0; }, true, "depth.asc");
    write_polygon("scar", {{200, 0}, {400, 0}, {400, 150}, {200, 150}});  // 100 m on the grid, 100 m beyond
    const Outcome outcome =
        frana({"compare", "depth.asc", "--scar", "scar.geojson", "--out", "scores", "--size", "800x600"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json_number(outcome.out, "observed_area_m2"), 200 * 150);
    EXPECT_EQ(json_number(outcome.out, "miss_m2"), 100 * 150);
    EXPECT_NE(outcome.err.find("beyond the computed ground"), std::string::npos) << outcome.err;
}

TEST_F(Compare, AResultAgainstAnOutlineInAnotherCrs) {
    write_scene(k_numbers_only);
    ASSERT_EQ(frana({"run", "scene.ini", "--out", "result", "--quiet"}).exit_code, 0);
    // About the release, in degrees: a few hundredths of a square kilometre, any overlap shows the
    // transformation works.
    write(
        "scar.geojson",
        R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[)"
        R"([9.3485, 45.9995], [9.3525, 45.9995], [9.3525, 46.0025], [9.3485, 46.0025], [9.3485, 45.9995]]]}})");
    const Outcome outcome = frana({"compare", "result", "--scar", "scar.geojson", "--size", "800x600"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(json_number(outcome.out, "hit_m2"), 0);
    EXPECT_EQ(json_number(outcome.out, "threshold_m"), 0.1);  // the result's own trace threshold
    EXPECT_TRUE(std::filesystem::exists(path("result/comparison.json")));
}

TEST_F(Compare, MissingScarFile) {
    write_dtm([](int, int) { return 1.0; }, true, "depth.asc");
    const Outcome outcome = frana({"compare", "depth.asc", "--scar", "none.shp", "--out", "scores"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("none.shp"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("scores")));
}

}  // namespace
}  // namespace frana::test
