// SPDX-License-Identifier: Apache-2.0
// Maps of probability against an outline, as a user sees it.
#include <gdal_priv.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class ProbabilityCompare : public Ensemble {
  protected:
    void SetUp() override {
        write_study("samples = 4\n", k_two_keys);
        ASSERT_EQ(run().exit_code, 0);
    }
    /// Writes p.tif: a map of the study with other values, 0.8 in 10 cells, 0.4 in the 10 cells south of them.
    void write_map() const {
        GDALAllRegister();
        const GDALDatasetUniquePtr from(
            GDALDataset::Open(path("out/probability_depth_0.5.tif").c_str(), GDAL_OF_RASTER));
        const GDALDatasetUniquePtr to(GetGDALDriverManager()->GetDriverByName("GTiff")->CreateCopy(
            path("p.tif").c_str(), from.get(), TRUE, nullptr, nullptr, nullptr));
        std::vector<float> values(static_cast<std::size_t>(k_rows) * k_columns);
        for (int row = 10; row < 14; ++row)
            for (int column = 10; column < 15; ++column)
                values[static_cast<std::size_t>(row * k_columns + column)] = row < 12 ? 0.8F : 0.4F;
        ASSERT_EQ(to->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, k_columns, k_rows, values.data(), k_columns, k_rows,
                                                 GDT_Float32, 0, 0),
                  CE_None);
    }
};

// The outline contains half of the cells of each probability: 10 cells, so 50 others, 10 of them with a probability.
TEST_F(ProbabilityCompare, OfAMapIsThatByHand) {
    write_map();
    write_polygon("scar", {{50, 85}, {75, 85}, {75, 95}, {50, 95}});
    const Outcome outcome =
        frana({"compare", "--json", "p.tif", "--scar", "scar.geojson", "--out", "scores", "--size", "640x480"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(parse_json(outcome.out).at("comparison"), parse_json(read_text(path("scores/comparison.json"))));
    constexpr double k_float32 = 1e-7;  // of 0.8 and 0.4
    EXPECT_NEAR(json_number(outcome.out, "brier"), (5 * 0.04 + 5 * 0.36 + 5 * 0.64 + 5 * 0.16) / 60, k_float32);
    EXPECT_NEAR(json_number(outcome.out, "auroc"), 0.1 * 0.25 + 0.1 * 0.75 + 0.8, 1e-12);
    EXPECT_EQ(json_number(outcome.out, "observed_area_m2"), 250);
    EXPECT_EQ(json_number(outcome.out, "compared_area_m2"), 1500);
    EXPECT_NEAR(json_number(outcome.out, "brier_reliability"), (10 * 0.3 * 0.3 + 10 * 0.1 * 0.1) / 60, k_float32);
    const gis::Table classes = gis::read_table(path("scores/reliability.csv"), "classes");
    ASSERT_EQ(classes.rows.size(), 10U);
    EXPECT_EQ(classes.rows[8][4], "0.5");
    EXPECT_EQ(classes.rows[0][2], "1000");
    const gis::Table curve = gis::read_table(path("scores/roc.csv"), "curve");
    ASSERT_EQ(curve.rows.size(), 2U);
    EXPECT_EQ(curve.rows[0][1], "0.5");
    EXPECT_EQ(curve.rows[0][2], "0.1");
    EXPECT_TRUE(fs::exists(path("scores/comparison.png")));
}

TEST_F(ProbabilityCompare, OfAStudyTakesTheMapOfAThreshold) {
    write_polygon("scar", {{20, 40}, {180, 40}, {180, 110}, {20, 110}});
    const Outcome least = frana({"compare", "--json", "out", "--scar", "scar.geojson", "--size", "640x480"});
    ASSERT_EQ(least.exit_code, 0) << least.err;
    EXPECT_EQ(json_text(least.out, "map"), "probability_depth_0.1");
    // The report of the study's result has the scores, in its own language.
    const std::string page = read_text(path("out/report.html"));
    EXPECT_NE(page.find("Brier score"), std::string::npos);
    EXPECT_EQ(page.find("Not compared with an observed outline"), std::string::npos);
    EXPECT_NE(least.out.find("report.html"), std::string::npos) << "named among the files written";
    const Outcome other =
        frana({"compare", "--json", "out", "--scar", "scar.geojson", "--threshold", "0.5", "--size", "640x480"});
    ASSERT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(json_text(other.out, "map"), "probability_depth_0.5");
    EXPECT_EQ(parse_json(read_text(path("out/comparison.json"))), parse_json(other.out).at("comparison"));
    const Outcome unknown = frana({"compare", "--json", "out", "--scar", "scar.geojson", "--threshold", "0.7"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("0.1, 0.5, 2"), std::string::npos) << unknown.err;
    EXPECT_EQ(parse_json(read_text(path("out/comparison.json"))), parse_json(other.out).at("comparison"));
}

TEST_F(ProbabilityCompare, TakesNoDeposit) {
    write_polygon("scar", {{20, 40}, {180, 40}, {180, 110}, {20, 110}});
    const Outcome deposit =
        frana({"compare", "--json", "out", "--scar", "scar.geojson", "--deposit", "scar.geojson", "--out", "ranking"});
    EXPECT_EQ(deposit.exit_code, 2);
    EXPECT_NE(deposit.err.find("--deposit"), std::string::npos) << deposit.err;
    EXPECT_FALSE(fs::exists(path("ranking")));
}

TEST_F(ProbabilityCompare, ARenamedMapIsDrawn) {
    write_map();
    const Outcome outcome = frana({"render", "p.tif", "--dtm", "dtm.asc", "--out", "drawn", "--size", "640x480"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(path("drawn/p.png")));
}

TEST_F(ProbabilityCompare, AStudyOfASceneWithAnOutlineIsCompared) {
    write_polygon("scar", {{20, 40}, {180, 40}, {180, 110}, {20, 110}});
    write("scene.ini", read_text(path("scene.ini")) + "[observed]\nperimeter = scar.geojson\n");
    const Outcome outcome = run({"--overwrite"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json own = parse_json(read_text(path("out/comparison.json")));
    EXPECT_EQ(own.at("kind"), "probability");
    EXPECT_EQ(own.at("simulated"), own.at("map").get<std::string>() + ".tif");
    const std::string report = read_text(path("out/report.html"));
    EXPECT_EQ(report.find("Not compared"), std::string::npos);
    EXPECT_NE(report.find("Brier score"), std::string::npos);
    EXPECT_NE(read_text(path("out/manifest.json")).find("comparison.json"), std::string::npos);
    // Drawn for the page: on 180 mm no letter is smaller than 6 points.
    const std::string section = report.substr(report.find("id=\"comparison\"")),
                      picture = section.substr(section.find("<svg"), section.find("</svg>") - section.find("<svg"));
    std::smatch found;
    ASSERT_TRUE(std::regex_search(picture, found, std::regex("viewBox=\"0 0 ([0-9.]+)")));
    const double points = 180 / 25.4 * 72 / std::stod(found[1]);
    const std::regex letters("font-size[=:]\"?([0-9.]+)");
    int sizes = 0;
    for (std::sregex_iterator at(picture.begin(), picture.end(), letters), end; at != end; ++at, ++sizes)
        EXPECT_GE(points * std::stod((*at)[1]), 6) << at->str();
    EXPECT_GT(sizes, 10);
    // As the command gives them.
    const Outcome command =
        frana({"compare", "--json", "out", "--scar", "scar.geojson", "--out", "again", "--size", "640x480"});
    ASSERT_EQ(command.exit_code, 0) << command.err;
    const Json scores = parse_json(command.out).at("comparison");
    for (const char* key : {"brier", "auroc", "observed_area_m2", "brier_skill"})
        EXPECT_EQ(scores.at(key), own.at(key)) << key;
}

}  // namespace
}  // namespace frana::test
