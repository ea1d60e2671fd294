// SPDX-License-Identifier: Apache-2.0
// The files of a result equal its table of rasters, and its values are computed once.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/trace.h"
#include "app/input/share_directory.h"
#include "app/pictures/result_reader.h"
#include "core/error.h"
#include "core/words/number_text.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "params/scene/read_scene.h"
#include "result_scenes.h"
#include "same_result.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class ResultTable : public ResultScenes {};

// A row specifies when its raster exists: every scene that requests it has it, and no other.
TEST_F(ResultTable, EveryResultHasTheRastersOfTheTable) {
    const std::map<std::string, std::string> scenes{
        {"first", k_voellmy + k_entrainment + k_numbers_only + "[hazard]\nscheme = austrian-torrent\n"},
        {"second", k_structured + k_numbers_only},
        {"fluid", "[material]\nmodel = structured\n[structured]\nphases = fluid\nmanning = 0.05\n" + k_numbers_only},
        {"least", k_voellmy + k_numbers_only}};
    for (const auto& [name, text] : scenes) {
        run(text, name);
        const SceneSpec scene = read_scene(path(name + "/scene.ini"), {}, app::share_directory()).scene;
        for (const ResultRaster& row : result_rasters()) {
            if (!row.in_result() || row.command != "run" || row.if_it_happens) continue;
            EXPECT_EQ(exists(name + "/" + row.name + ".tif"),
                      row.is_produced_by == nullptr || row.is_produced_by(scene))
                << name << ": " << row.name;
            if (row.is_drawn()) {
                EXPECT_EQ(exists(name + "/" + row.name + ".qml"), exists(name + "/" + row.name + ".tif")) << row.name;
            }
        }
    }
}

// The values on a map are those of summary.json, not computed separately.
TEST_F(ResultTable, MapsShowTheValuesOfTheSummary) {
    run(k_voellmy + k_numbers_only, "old");
    const auto notes = [&] { return joined(app::ResultReader(path("old")).map_source().notes, "; "); };
    const std::string summary = read_text(path("old/summary.json"));
    Json changed = parse_json(summary);
    changed["covered_area_m2"] = 123456;
    changed["runout"]["horizontal_m"] = 4321;
    write("old/summary.json", frana::json_text(changed));
    expect_words(notes(), {"Covered area (> 0.1 m): 123 456 m²", "Run-out: 4 321 m"});
    fs::remove(path("old/summary.json"));
    EXPECT_EQ(notes().find("Run-out"), std::string::npos) << notes();
    EXPECT_NE(notes().find("Volume"), std::string::npos) << notes();
    write("old/summary.json", summary.substr(0, summary.size() / 2));
    EXPECT_THROW(notes(), Error);
}

// Maps, frames and GIS styles of a run have the same classes, as many as its values need.
TEST_F(ResultTable, ClassesAreTheSameOnMapsFramesAndInStyles) {
    run(k_voellmy + "[output]\nmaps = off\nanimation = off\nreport = off\n", "old");
    const app::ResultReader result(path("old"));
    const std::vector<double> classes = result.map_layer("max_depth").classes;
    for (const std::string name : {"final_depth", "depth@1"})
        EXPECT_EQ(result.map_layer(name).classes, classes) << name;
    for (const std::string name : {"max_depth", "max_velocity", "max_pressure"}) {
        const app::MapLayer layer = result.map_layer(name);
        std::vector<double> bounds = layer.classes;
        if (std::isinf(bounds.back())) bounds.pop_back();  // above it the release alone
        EXPECT_LT(bounds[bounds.size() - 2], maximum(layer.values)) << name << ": a class that nothing is in";
    }
    for (const std::string style : {"max_depth", "final_depth", "frames/depth"})
        for (std::size_t i = 0; i + 1 < classes.size() && std::isfinite(classes[i + 1]); ++i)
            for (const std::string ending : {".qml", ".sld"})
                EXPECT_NE(read_text(path("old/" + style + ending))
                              .find(number_text(classes[i]) + " \u2013 " + number_text(classes[i + 1]) + " m"),
                          std::string::npos)
                    << style << ending << " " << classes[i];
}

// The names and ids that polygons have in the user's file are in every output.
TEST_F(ResultTable, NamesAndIdsOfReleaseAreasReachOutlinesSummaryLogReportAndMap) {
    std::string perimeter = read_text(path("perimeter.geojson"));
    const std::string depth = "\"depth\": 2.0";
    const auto at = perimeter.find(depth);
    ASSERT_NE(at, std::string::npos) << perimeter;
    write("perimeter.geojson", perimeter.insert(at + depth.size(), ", \"Name\": \"Upper scar\", \"ID\": \"A-17\""));
    const std::string name = "Upper scar (A-17)";
    run(k_voellmy + k_numbers_only, "old");
    EXPECT_EQ(parse_json(read_text(path("old/summary.json")))["release_areas"][0]["name"], name);
    EXPECT_NE(read_text(path("old/log.txt")).find("release 1 '" + name + "'"), std::string::npos);
    const auto areas = gis::read_polygons(path("old/extent.gpkg") + "|layer=release", "EPSG:32632", "test");
    EXPECT_EQ(areas.features.at(0).texts.at("name"), name);
    EXPECT_EQ(app::ResultReader(path("old")).map_source().release_names, std::vector<std::string>{name});
    run(k_voellmy + k_pages_only, "reported");
    EXPECT_NE(read_text(path("reported/report.html")).find("<td>" + name + "</td>"), std::string::npos);
}

// The project follows the files of the result; one that was saved from QGIS stays as it is.
TEST_F(ResultTable, AComparisonIsAddedToTheProject) {
    run(k_voellmy + k_numbers_only, "old");
    const std::string before = read_text(path("old/result.qgz"));
    succeeded(frana({"compare", "old", "--scar", "scar.geojson"}));
    EXPECT_GT(read_text(path("old/result.qgz")).size(), before.size()) << "one layer more";
    write("old/result.qgz", "saved from QGIS");
    succeeded(frana({"compare", "old", "--scar", "scar.geojson"}));
    EXPECT_EQ(read_text(path("old/result.qgz")), "saved from QGIS");
}

}  // namespace
}  // namespace frana::test
