// SPDX-License-Identifier: Apache-2.0
// What a study says of the friction table of its scene.
#include <nlohmann/json.hpp>

#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "study/tiny_study.h"

namespace frana::test {
namespace {

std::map<std::string, std::string> metadata_of(const std::string& raster) {
    return gis::read_raster_text(raster).metadata;
}

TEST_F(Ensemble, SaysWhoseFrictionAfterATableItShows) {
    write_scene(k_pages_only + "charts = off\n");
    const std::string scene = read_text(path("scene.ini"));
    const auto at = scene.find("friction-angle = "), end = scene.find("[time]", at);
    ASSERT_TRUE(at != std::string::npos && end != std::string::npos) << scene;
    write("scene.ini",
          scene.substr(0, at) + "friction-table = ngi-avalanche\nreturn-period = 100\n" + scene.substr(end));
    write_study("samples = 4\n",
                "[vary]\nmaterial.table-friction-factor = uniform(0.8, 1)\n"
                "release.volume = uniform(3000, 4000)\nmaterial.density = uniform(1900, 2100)\n");
    const Outcome checked = frana({"check", "study.ini"});
    EXPECT_NE(checked.out.find("central scene: NGI, Voellmy friction"), std::string::npos) << checked.out;
    succeeded(run());
    const Json table = parse_json(read_text(path("out/summary.json")))["friction_table"];
    EXPECT_EQ(table["name"], "ngi-avalanche");
    EXPECT_EQ(table["of"], "central scene");
    EXPECT_EQ(table["varied_by"], (Json{"material.table-friction-factor", "release.volume"}));
    EXPECT_NEAR(table["friction_factor"], 0.9, 1e-12);
    EXPECT_NEAR(table["volume_m3"], 3500, 1);
    double area = 0, reached = 0;
    for (const Json& one : table["areas"]) area += one["area_m2"].get<double>();
    const Raster probability = gis::read_result_raster(path("out/probability_depth_0.1.tif"));
    for (const double value : probability.values) reached += value > 0 ? probability.grid.cell_area() : 0;
    EXPECT_GT(area, 0);
    EXPECT_EQ(area, reached);
    for (const std::string raster : {"mu", "xi"}) {
        const auto metadata = metadata_of(path("out/" + raster + ".tif"));
        EXPECT_EQ(metadata.at("FRICTION_OF"), "central scene");
        EXPECT_EQ(metadata.at("FRICTION_VARIED_BY"), "material.table-friction-factor, release.volume");
    }
    const std::string report = read_text(path("out/report.html"));
    expect_words(report, {"central scene", "Varied: table-friction-factor, volume",
                          "NGI, Voellmy friction of avalanches, 100 years"});
    EXPECT_NE(read_text(path("out/inputs.json")).find("ngi-avalanche.ini"), std::string::npos);
    // Refused before a member runs: 5.2 times 0.45 is more than 2.
    write_study("samples = 4\n", "[vary]\nmaterial.table-friction-factor = uniform(0.8, 5.2)\n");
    refusal_of(frana({"ensemble", "study.ini", "--out", "too_much", "--quiet"}), {"material.table-friction-factor"});
    // Each source has a volume of its own.
    write("union.ini", "[region]\nscene = scene.ini\n");
    succeeded(frana({"batch", "union.ini", "--out", "union", "--quiet"}));
    EXPECT_EQ(metadata_of(path("union/mu.tif")).at("FRICTION_OF"), "largest source");
    EXPECT_NE(read_text(path("union/report.html")).find("Friction of the source with the largest area"),
              std::string::npos);
}

}  // namespace
}  // namespace frana::test
