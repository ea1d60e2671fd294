// SPDX-License-Identifier: Apache-2.0
// Run-out, drop and angle of reach of several flows, through the program: masses that stay where they are on an
// inclined plane, so that every value follows from the geometry.
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

/// The plane falls 0.5 m per cell of 5 m to the east; 45 degrees of friction hold 1 m of material.
class SeparateFlowsCli : public TinyScene {
  protected:
    void make_scene(const std::string& parts, const std::string& more = "") const {
        write_dtm([](int, int column) { return 300 - 0.5 * column; });
        write("perimeter.geojson",
              R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},"features":[)"
              R"({"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon","coordinates":[)" +
                  parts + "]}}]}");
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 1\n[material]\n"
              "friction-angle = 45\n[time]\nend = 2\n[output]\nanimation = off\nreport = off\nframes = off\n" +
                  more);
    }
    /// A rectangle between columns and rows of the grid, rows counted from the south.
    static std::string cells(int column, int row, int columns, int rows) {
        const auto corner = [](int i, int j) {
            return "[" + std::to_string(k_west + k_cell * i) + "," + std::to_string(k_south + k_cell * j) + "]";
        };
        return "[[" + corner(column, row) + "," + corner(column + columns, row) + "," +
               corner(column + columns, row + rows) + "," + corner(column, row + rows) + "," + corner(column, row) +
               "]]";
    }
    [[nodiscard]] Json summary_of_run(const std::vector<std::string>& more = {}) const {
        succeeded(frana(with_more({"run", "scene.ini", "--out", "result", "--overwrite", "--quiet"}, more)));
        return Json::parse(read_text(path("result/summary.json")));
    }
    /// The last row's value of a column of timeseries.csv.
    [[nodiscard]] double last_front() const {
        const std::string text = read_text(path("result/timeseries.csv"));
        std::size_t at = text.rfind('\n', text.size() - 2);
        for (int comma = 0; comma < 7; ++comma) at = text.find(',', at + 1);
        return std::stod(text.substr(at + 1));
    }
};

// The material of 4 x 4 cells also shows in the cells beside, one on each side and none at the corners (quadratic
// splines). From the north-western cell's centre the farthest is 20 m east and 15 m south of it: 25 m. The bed falls 2
// m to there, and 1 m of material lies on it.
TEST_F(SeparateFlowsCli, TwoReleasesFarApartHaveTwoRunOuts) {
    make_scene(cells(4, 12, 4, 4) + "," + cells(50, 12, 4, 2));
    const Json summary = summary_of_run({"--set", "output.report=on"});
    ASSERT_EQ(summary["flows"].size(), 2);
    const Json &longest = summary["runout"], &first = summary["flows"][0], &second = summary["flows"][1];
    EXPECT_NEAR(longest["horizontal_m"].get<double>(), 25, 1e-9);
    EXPECT_NEAR(longest["drop_m"].get<double>(), 3, 1e-9);
    EXPECT_NEAR(longest["reach_angle_deg"].get<double>(), 6.8428, 1e-4);  // atan(3 / 25)
    for (const char* key : {"horizontal_m", "drop_m", "reach_angle_deg"}) EXPECT_EQ(first[key], longest[key]) << key;
    EXPECT_NEAR(first["covered_area_m2"].get<double>(), (16 + 16) * 25, 1e-9);
    EXPECT_NEAR(second["horizontal_m"].get<double>(), std::hypot(20, 5), 1e-9);
    EXPECT_NEAR(second["drop_m"].get<double>(), 3, 1e-9);
    EXPECT_NEAR(second["covered_area_m2"].get<double>(), (8 + 12) * 25, 1e-9);
    EXPECT_NEAR(second["top_x"].get<double>(), k_west + 50.5 * k_cell, 1e-9);
    // From the nearest release's centroid: particles lie inside the half diagonal.
    EXPECT_GT(last_front(), 0.5 * std::hypot(15, 15));
    EXPECT_LT(last_front(), 0.5 * std::hypot(20, 20));
    const std::string report = read_text(path("result/report.html"));
    EXPECT_NE(report.find("Run-out [m]"), std::string::npos);
}

}  // namespace
}  // namespace frana::test
