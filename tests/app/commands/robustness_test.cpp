// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/text.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class RobustnessCommand : public TinyScene {
  protected:
    // robustness.csv of a folder: cells by row.
    [[nodiscard]] std::vector<std::vector<std::string>> table(const std::string& folder) const {
        std::vector<std::vector<std::string>> rows;
        std::istringstream text(read_text(path(folder + "/robustness.csv")));
        for (std::string line; std::getline(text, line);) {
            std::istringstream cells(line);
            rows.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
        }
        return rows;
    }
};

TEST_F(RobustnessCommand, RunsTheSceneUnderEveryDisturbance) {
    // With gullies, so that no two cells have the same height and every value is unique.
    write_dtm([](int row, int column) {
        const double x = k_cell * column, y = k_cell * row;
        return 400 - 0.5 * x + 0.15 * std::abs(y - 75 - 8 * std::sin(x / 23)) + 0.003 * x * x * (x > 150);
    });
    write_scene();
    const Outcome outcome = frana({"bench", "robustness", "scene.ini", "--set", "time.end=6", "--out", "study"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("changes against the first row"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("turned-45"), std::string::npos) << outcome.err;
    const auto rows = table("study");
    std::vector<std::string> names;
    for (const auto& row : rows) names.push_back(row[0]);
    EXPECT_EQ(names, (std::vector<std::string>{"disturbance", "base", "shifted", "turned-30", "turned-45", "turned-90",
                                               "rough", "particles-1", "particles-9", "particles-16", "cfl-0.2",
                                               "cfl-0.35", "cfl-0.5", "cfl-0.65", "cfl-0.95"}));
    for (std::size_t row = 1; row < rows.size(); ++row) {
        ASSERT_EQ(rows[row].size(), rows[0].size());
        EXPECT_EQ(rows[row].back(), "done");
        for (std::size_t column = 1; column < 19; ++column) {
            const double value = std::stod(rows[row][column]);
            // Only rounding if the grid is turned by a quarter; otherwise a flow of a few cells' width.
            const double limit = rows[row][0] == "turned-90" ? 1e-9 : 0.5;
            const bool is_change = column % 2 == 0;
            EXPECT_TRUE(is_change ? std::abs(value) <= limit : value > 0.1)
                << rows[row][0] << ' ' << rows[0][column] << ' ' << value;
        }
    }
    // The first row is the run itself.
    ASSERT_EQ(frana({"run", "scene.ini", "--set", "time.end=6", "--out", "result", "--set", "output.maps=off", "--set",
                     "output.animation=off", "--quiet"})
                  .exit_code,
              0);
    const std::string summary = read_text(path("result/summary.json"));
    for (std::size_t column = 1; column < 15; column += 2) {
        EXPECT_EQ(rows[1][column], shortest_text(json_number(summary, rows[0][column]))) << rows[0][column];
        EXPECT_EQ(rows[1][column + 1], "0");
    }
    EXPECT_EQ(rows[1][15], shortest_text(json_number(summary, "horizontal_m")));
    EXPECT_NEAR(std::stod(rows[1][17]),
                json_number(summary, "final_depth_raster_m3") / json_number(summary, "final_m3"), 1e-12);
    const std::string json = read_text(path("study/robustness.json"));
    EXPECT_EQ(json_number(json, "seed"), 1);
}

TEST_F(RobustnessCommand, RunsBothModels) {
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "model = structured\n[structured]\nphases = solids-and-fluid\ncohesion = 2000\ninternal-friction-angle = 30\n"
          "[numerics]\nparticles-per-cell = "
          "9\n[time]\n"
          "end = 1\n");
    const Outcome outcome = frana({"bench", "robustness", "scene.ini", "--out", "study", "--quiet", "--case",
                                   "turned-30", "--case", "particles-4"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto rows = table("study");
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[2].back(), "done");
    EXPECT_EQ(rows[3].back(), "refused");  // too small for the neighbour sums of solids
    EXPECT_NE(outcome.out.find("too small"), std::string::npos) << outcome.out;
}

TEST_F(RobustnessCommand, RefusesBeforeAnythingIsComputed) {
    write_scene();
    const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
        std::vector<std::string> call{"bench", "robustness"};
        call.insert(call.end(), more.begin(), more.end());
        const Outcome outcome = frana(call);
        EXPECT_EQ(outcome.exit_code, 2) << words;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    };
    refused({}, "SCENE.ini is missing");
    refused({"scene.ini", "other.ini"}, "is not expected here");
    refused({"missing.ini"}, "missing.ini");
    refused({"scene.ini", "--case", "turned-91"}, "turned-90");
    refused({"scene.ini", "--seed", "-1"}, "--seed");
    refused({"scene.ini", "--set", "numerics.cfl=7"}, "numerics.cfl");
    fs::create_directory(path("study"));
    std::ofstream(path("study/robustness.csv")) << "the user's\n";
    refused({"scene.ini", "--out", "study"}, "was not written by frana");
    EXPECT_EQ(read_text(path("study/robustness.csv")), "the user's\n");
    EXPECT_EQ(frana({"bench", "accuracy", "scene.ini"}).exit_code, 2);
}

}  // namespace
}  // namespace frana::test
