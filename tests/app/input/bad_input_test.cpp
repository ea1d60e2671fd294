// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

/// A scene with one problem: the change to a valid one, and words that the one message must contain.
struct BadInput {
    std::string name;
    std::string lines;                   ///< after the valid scene
    std::vector<std::string> overrides;  ///< --set
    std::vector<std::string> messages;
};

void PrintTo(const BadInput& tested, std::ostream* out) {
    *out << tested.name;
}

class BadKey : public TinyScene, public ::testing::WithParamInterface<BadInput> {};

TEST_P(BadKey, IsRefusedInOneMessageWithNothingWritten) {
    const BadInput& tested = GetParam();
    write_scene(tested.lines);
    write("empty.geojson", R"({"type": "FeatureCollection", "features": []})");
    const std::vector<std::string> before = files();
    for (const std::string command : {"run", "check"}) {
        std::vector<std::string> arguments{command, "scene.ini"};
        for (const std::string& text : tested.overrides) {
            arguments.emplace_back("--set");
            arguments.push_back(text);
        }
        const Outcome outcome = frana(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.rfind("frana: ", 0), 0U) << outcome.err;
        for (const std::string& words : tested.messages)
            EXPECT_NE(outcome.err.find(words), std::string::npos) << "no \"" << words << "\" in: " << outcome.err;
    }
    EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadKey,
    ::testing::Values(
        BadInput{"missing_dtm", "", {"terrain.dtm=none.tif"}, {"--set terrain.dtm", "none.tif"}},
        BadInput{"dtm_is_text", "", {"terrain.dtm=scene.ini"}, {"--set terrain.dtm", "scene.ini"}},
        BadInput{"missing_perimeter", "", {"release.perimeter=none.shp"}, {"release.perimeter", "none.shp"}},
        BadInput{"empty_perimeter", "", {"release.perimeter=empty.geojson"}, {"release.perimeter", "empty.geojson"}},
        BadInput{
            "unknown_key", "[numerics]\nclf = 0.4\n", {}, {"scene.ini: numerics.clf", "Did you mean numerics.cfl?"}},
        BadInput{"out_of_range", "[numerics]\ncfl = 3\n", {}, {"numerics.cfl", "value 3", "greater than 0, at most 1"}},
        BadInput{"negative_thickness", "", {"release.thickness=-1"}, {"release.thickness", "-1", "greater than 0"}},
        BadInput{
            "attribute_missing", "", {"release.thickness=attribute:D"}, {"release.thickness", "attribute D", "depth"}},
        BadInput{"crs_not_metric", "", {"terrain.crs=EPSG:4326"}, {"terrain.crs", "projected"}},
        BadInput{"crs_unknown", "", {"terrain.crs=EPSG:999999"}, {"terrain.crs", "999999"}},
        BadInput{"scar_missing", "", {"scar.perimeter=scar.shp"}, {"scar.perimeter", "scar.shp"}},
        BadInput{"bounds_elsewhere", "", {"terrain.bounds=0 0 10 10"}, {"527000"}},
        BadInput{"erodible_below_zero",
                 "[entrainment]\nerosion = shear-stress\nerodible-depth = -0.5\n",
                 {},
                 {"scene.ini: entrainment.erodible-depth", "-0.5", "0 to 1000"}},
        BadInput{"law_without_its_key",
                 "",
                 {"material.bed-friction=voellmy, cohesion"},
                 {"material.cohesion", "is missing"}},
        BadInput{"key_without_its_law", "", {"material.manning=0.05"}, {"material.manning", "no law of the scene"}},
        BadInput{
            "contradiction", "", {"material.friction-angle=20", "material.friction-coefficient=0.3"}, {"contradicts"}}),
    [](const auto& tested) { return tested.param.name; });

using BadFile = TinyScene;

TEST_F(BadFile, EveryProblemInOnePass) {
    write_scene("[numerics]\nclf = 0.4\n[output]\ntrace-threshold = deep\n");
    const Outcome outcome =
        frana({"run", "scene.ini", "--set", "terrain.dtm=none.tif", "--set", "scar.perimeter=nowhere.shp"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err.rfind("frana: 4 problems:\n", 0), 0U) << outcome.err;
    for (const std::string words : {"numerics.clf", "output.trace-threshold", "none.tif", "nowhere.shp"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

TEST_F(BadFile, DtmWithoutCrsIsRefusedWithARemedy) {
    write_dtm({}, false);
    const Outcome outcome = frana({"run", "scene.ini"});
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string words : {"terrain.dtm", "no coordinate reference system", "terrain.dtm-crs", "local"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.dtm-crs=EPSG:32632"}).exit_code, 0);
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.crs=local"}).exit_code, 0);
}

// Three polygons, of which one has a number in another column and none in that of the key.
TEST_F(BadFile, AColumnThatNoPolygonHasANumberInIsToldOnce) {
    const auto polygon = [](int east, const std::string& properties) {
        const auto corner = [&](double x, double y) {
            return "[" + std::to_string(k_west + east + x) + "," + std::to_string(k_south + y) + "]";
        };
        return R"({"type": "Feature", "properties": {)" + properties +
               R"(}, "geometry": {"type": "Polygon", "coordinates": [[)" + corner(0, 55) + "," + corner(10, 55) + "," +
               corner(10, 95) + "," + corner(0, 55) + "]]}}";
    };
    write("many.geojson", R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": )"
                          R"({"name": "urn:ogc:def:crs:EPSG::32632"}}, "features": [)" +
                              polygon(20, R"("dicke": null, "title": "A")") + "," +
                              polygon(40, R"("dicke": 2, "title": "B")") + "," +
                              polygon(60, R"("dicke": null, "title": "C")") + "]}");
    const auto check = [&](const std::string& column) {
        const Outcome outcome = frana({"check", "scene.ini", "--set", "release.perimeter=many.geojson", "--set",
                                       "release.thickness=attribute:" + column});
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        return outcome.err;
    };
    for (const std::string column : {"Dicke_m", "title"}) {
        const std::string error = check(column);
        EXPECT_NE(error.find("no number in the attribute " + column + " of any feature of many"), std::string::npos)
            << error;
        EXPECT_NE(error.find("attributes with numbers: dicke)"), std::string::npos) << error;
    }
    EXPECT_NE(check("title").find("finds text"), std::string::npos);
    EXPECT_NE(check("dicke").find("is empty (NULL) in the attribute dicke of 2 of 3 features"), std::string::npos);
}

TEST_F(BadFile, PerimeterOutsideNamesBothExtents) {
    write_polygon("perimeter", {{1020, 55}, {1070, 55}, {1070, 95}});
    const Outcome outcome = frana({"run", "scene.ini"});
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string words : {"outside the DTM", "west 528020.00", "west 527000.00", "east 527300.00"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

TEST_F(BadFile, NodataUnderTheReleaseNamesTheCells) {
    // Row 14 spans y = 75 to 80 m, column 8 spans x = 40 to 45 m: inside the release.
    write_dtm([](int row, int column) { return row == 14 && column == 8 ? -9999.0 : 300 - 2.5 * column; });
    const Outcome outcome = frana({"run", "scene.ini"});
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string words : {"1 cell: row 14 column 8 at 527042.5, 5094077.5", "nodata-policy"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.nodata-policy=fill"}).exit_code, 0);
}

TEST_F(BadFile, SelfCrossingPolygonIsRefused) {
    write_polygon("perimeter", {{20, 55}, {70, 95}, {70, 55}, {20, 95}});
    const Outcome outcome = frana({"run", "scene.ini"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("release.perimeter"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("527045"), std::string::npos) << "the crossing's place: " << outcome.err;
}

TEST_F(BadFile, NegativeThicknessRasterNamesCells) {
    write_dtm([](int, int) { return -3.0; }, true, "thickness.asc");
    const Outcome outcome = frana({"run", "scene.ini", "--set", "release.thickness=raster:thickness.asc"});
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string words : {"release.thickness", "negative", "row 11 column 4"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

TEST_F(BadFile, UnwritableOutput) {
    // Nobody can create a folder below a file, not even root.
    const Outcome outcome = frana({"run", "scene.ini", "--out", "scene.ini/result"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("--out: cannot be written"), std::string::npos) << outcome.err;
    EXPECT_EQ(frana({"run", "scene.ini", "--out", "scene.ini"}).exit_code, 2);
}

TEST_F(BadFile, FoldersThatAreNoResultsAreNeverReplaced) {
    std::filesystem::create_directory(folder_ / "photos");
    write("photos/one.jpg", "precious");
    const Outcome outcome = frana({"run", "scene.ini", "--out", "photos", "--overwrite"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("never overwritten"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_text(path("photos/one.jpg")), "precious");
}

}  // namespace
}  // namespace frana::test
