// SPDX-License-Identifier: Apache-2.0
// Run-out, drop and angle of reach of several flows, through the program: masses that stay where they are on an
// inclined plane, so that every value follows from the geometry.
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "tiny_scene.h"

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
              "friction-angle = 45\n[time]\nend = 2\n[output]\nanimation = off\nframes = off\n" +
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
        std::vector<std::string> words{"run", "scene.ini", "--out", "result", "--overwrite", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = frana(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
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

// 4 x 4 cells: from the north-western cell's centre to the south-eastern one's it is 15 m in both directions; the bed
// falls 1.5 m, and 1 m of material lies on it.
TEST_F(SeparateFlowsCli, TwoReleasesFarApartHaveTwoRunOuts) {
    make_scene(cells(4, 12, 4, 4) + "," + cells(50, 12, 4, 2));
    const Json summary = summary_of_run();
    const double run_out = std::hypot(15, 15);
    ASSERT_EQ(summary["flows"].size(), 2);
    EXPECT_NEAR(summary["runout"]["horizontal_m"].get<double>(), run_out, 1e-9);
    EXPECT_NEAR(summary["runout"]["drop_m"].get<double>(), 2.5, 0.01);
    EXPECT_NEAR(summary["runout"]["reach_angle_deg"].get<double>(), 6.723, 0.03);  // atan(2.5 / 21.213)
    EXPECT_EQ(summary["flows"][0]["horizontal_m"], summary["runout"]["horizontal_m"]);
    EXPECT_NEAR(summary["flows"][0]["covered_area_m2"].get<double>(), 400, 1e-9);
    EXPECT_NEAR(summary["flows"][1]["horizontal_m"].get<double>(), std::hypot(15, 5), 1e-9);
    EXPECT_NEAR(summary["flows"][1]["covered_area_m2"].get<double>(), 200, 1e-9);
    EXPECT_NEAR(summary["flows"][1]["top_x"].get<double>(), k_west + 50.5 * k_cell, 1e-9);
    // From the nearest release's centroid: particles lie inside the half diagonal.
    EXPECT_GT(last_front(), 0.5 * run_out);
    EXPECT_LT(last_front(), 0.5 * std::hypot(20, 20));
    const std::string report = read_text(path("result/report.html"));
    EXPECT_NE(report.find("2 flows never met"), std::string::npos);
}

}  // namespace
}  // namespace frana::test
