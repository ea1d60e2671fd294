// SPDX-License-Identifier: Apache-2.0
// Interpretation of inputs, and the messages about it.
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <numbers>

#include "gis/access/gdal_session.h"
#include "gis/raster/raster_in.h"
#include "support/checked_scene.h"
#include "support/files.h"

namespace frana::test {
namespace {

using Input = CheckedScene;

/// A slope that falls east by `drop` per column, as an ASCII grid without a .prj.
std::string slope_grid(const std::string& corner_and_cell, int columns, int rows, double drop) {
    std::string text = "ncols " + std::to_string(columns) + "\nnrows " + std::to_string(rows) + "\n" + corner_and_cell +
                       "\nNODATA_value -9999\n";
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            text += std::to_string(300 - drop * column) + (column + 1 < columns ? ' ' : '\n');
    return text;
}

std::string polygon_geojson(const std::string& rings) {
    return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}, "geometry": )"
           R"({"type": "MultiPolygon", "coordinates": [)" +
           rings + "]}}]}";
}

TEST_F(Input, CheckPrintsThemAsOneTable) {
    // The release's outline in Gauss-Boaga, by gdaltransform -s_srs EPSG:32632 -t_srs EPSG:3003 to the metre.
    write("scar.geojson",
          R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": )"
          R"("urn:ogc:def:crs:EPSG::3003"}}, "features": [{"type": "Feature", "properties": {}, "geometry": )"
          R"({"type": "Polygon", "coordinates": [[[1527048, 5094076], [1527098, 5094076], [1527098, 5094116], )"
          R"([1527048, 5094076]]]}}]})");
    const Outcome outcome = succeeded(frana({"check", "scene.ini", "--set", "scar.perimeter=scar.geojson"}));
    expect_words(outcome.out, {"Input",
                               "CRS",
                               "Extent (west south, east north)",
                               "Resolution",
                               "No data",
                               "Operation to the",
                               "Accuracy",
                               "DTM",
                               "dtm.asc",
                               "527000.00 5094000.00",
                               "527300.00 5094150.00",
                               "60 x 30",
                               "5 x 5",
                               "-9999",
                               "exact copy",
                               "perimeter.geojson",
                               "2 000 m2",
                               "scar.geojson",
                               "EPSG:3003",
                               "Monte",
                               "4 m",
                               "Working grid",
                               "memory of a run: about"});
    // Half a cell is 2.5 m; the register states 4 m for Monte Mario.
    expect_words(outcome.err, {"Observed outline: position ± 4 m", "half a cell is 2.5 m"});
    std::size_t tables = 0;
    for (std::size_t at = 0; (at = outcome.out.find("Extent (west", at)) != std::string::npos; ++at) ++tables;
    EXPECT_EQ(tables, 1U);
}

TEST_F(Input, TheLogStatesOperationsAndResampling) {
    write_scene(k_numbers_only);
    ran("result", {"time.end=0.1", "terrain.cell-size=2"});
    expect_words(read_text(path("result/log.txt")), {"resampling bilinear"});
    ran("coarse", {"time.end=0.1", "terrain.crs=EPSG:3003", "terrain.cell-size=10"});
    expect_words(read_text(path("coarse/log.txt")), {"resampling average", "DTM transformed by:", "Monte Mario",
                                                     "accuracy 4 m", "perimeter transformed by:"});
    // Austria's system in Italy: no survey connects them there, and PROJ leaves the datum unchanged.
    expect_words(check({"terrain.crs=EPSG:31287"}).told(),
                 {"DTM: transformation accuracy unknown", "Ballpark", "position may be wrong"});
    EXPECT_EQ(gis::read_result_raster(path("coarse/dtm.tif")).grid.cell_size, 10) << "the DTM really used is kept";
}

TEST_F(Input, AMapThatIsNotTrueToScaleIsNotComputedOn) {
    // Web Mercator over the scene: gdaltransform puts 527000, 5094000 at 1040690.9, 5780195.5; at 46 N its
    // metre is 0.69 m on the ground.
    write("mercator.asc", slope_grid("xllcorner 1040640\nyllcorner 5780150\ncellsize 7", 80, 50, 2));
    const Checked checked = check({"terrain.dtm=mercator.asc", "terrain.dtm-crs=EPSG:3857"});
    ASSERT_FALSE(checked.is_refused()) << checked.told();
    expect_words(checked.told(), {"EPSG:3857", "scale", "UTM"});
    expect_words(checked.prepared->ground.crs_label, {"EPSG:32632"});
    EXPECT_NEAR(checked.prepared->release.area_m2, 2000, 0.5);
    const std::string asked =
        check({"terrain.dtm=mercator.asc", "terrain.dtm-crs=EPSG:3857", "terrain.crs=EPSG:3857"}).told();
    expect_words(asked, {"terrain.crs", "EPSG:3857 with a scale of 1.43", "within 1 %"});
}

TEST_F(Input, FeetAreNeverGuessed) {
    // Washington State Plane North: 80 x 60 cells of 20 survey feet, elevations without a unit.
    write("feet.asc", slope_grid("xllcorner 1300000\nyllcorner 200000\ncellsize 20", 80, 60, 10));
    write("feet.geojson", polygon_geojson("[[[1300200, 200400], [1300400, 200400], [1300400, 200600], "
                                          "[1300200, 200600], [1300200, 200400]]]"));
    Sets sets{"terrain.dtm=feet.asc", "terrain.dtm-crs=EPSG:2285", "release.perimeter=feet.geojson",
              "release.perimeter-crs=EPSG:2285"};
    expect_words(check(sets).told(), {"terrain.dtm", "unit", "0.3048006", "terrain.vertical-unit"});
    Sets with_unit = sets;
    with_unit.emplace_back("terrain.vertical-unit=us-survey-foot");
    const Checked checked = check(with_unit);
    ASSERT_FALSE(checked.is_refused()) << checked.told();
    // The area between the corners that gdaltransform gives for EPSG:32610.
    expect_words(checked.prepared->ground.crs_label, {"EPSG:32610"});
    EXPECT_NEAR(checked.prepared->release.area_m2, 3714, 0.5);
    // A CRS with a vertical unit decides it.
    sets[1] = "terrain.dtm-crs=EPSG:2285+6360";
    EXPECT_FALSE(check(sets).is_refused());
}

TEST_F(Input, AFrameOfZerosIsReportedAndDeclared) {
    write_dtm([](int row, int column) { return row < 3 ? 0.0 : 300 - 2.5 * column; });
    expect_words(check().told(), {"180 cells of 0 stand out", "set terrain.nodata-value = 0"});
    const Checked declared = check({"terrain.nodata-value=0"});
    EXPECT_EQ(declared.told(), "");
    EXPECT_EQ(declared.prepared->ground.nodata_cells, 180);
}

TEST_F(Input, LavangsdalenIsFramedByZeros) {
    const std::string data = FRANA_SHARED_DIR "/data/lavangsdalen";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "the event's data are not at " << data;
    Sets sets{"terrain.dtm=" + data + "/dem_5m.tif", "release.perimeter=" + data + "/release.shp"};
    // Counted with gdal_translate -of AAIGrid and a line of awk: 32 300 of 168 873 cells are 0.
    expect_words(check(sets).told(), {"32 300 cells of 0 stand out", "terrain.nodata-value = 0"});
    sets.emplace_back("terrain.nodata-value=0");
    const Checked declared = check(sets);
    EXPECT_EQ(declared.told(), "");
    EXPECT_EQ(declared.prepared->ground.nodata_cells, 32300);
    expect_words(declared.prepared->ground.crs_label, {"EPSG:25833"});
}

TEST_F(Input, ArchivesCountFromTheScene) {
    {
        const gis::GdalSession session;
        const std::string grid = read_text(path("dtm.asc"));
        VSILFILE* file = VSIFOpenL(("/vsizip/" + path("tiles.zip") + "/dtm.asc").c_str(), "wb");
        ASSERT_TRUE(file);
        VSIFWriteL(grid.data(), 1, grid.size(), file);
        VSIFCloseL(file);
    }
    std::filesystem::remove(path("dtm.asc"));
    const Checked checked = check({"terrain.dtm=/vsizip/tiles.zip/dtm.asc", "terrain.dtm-crs=EPSG:32632"});
    EXPECT_FALSE(checked.is_refused()) << checked.told();
}

TEST_F(Input, AFilterChoosesFeatures) {
    const auto triangle = [](double west) { return Places{{west, 55}, {west + 50, 55}, {west + 50, 95}}; };
    write_features(
        "two", {{"Polygon", triangle(20), R"("kind": "release")"}, {"Polygon", triangle(220), R"("kind": "deposit")"}});
    const Checked checked = check({"release.perimeter=two.geojson", "release.perimeter-filter=kind = 'release'"});
    ASSERT_FALSE(checked.is_refused()) << checked.told();
    EXPECT_EQ(checked.prepared->scene.release.size(), 1U);
    EXPECT_EQ(checked.prepared->release.area_m2, 1000);
    expect_words(check({"release.perimeter=two.geojson", "release.perimeter-filter=sort = 'release'"}).told(),
                 {"release.perimeter", "sort = 'release'", "kind"});
}

struct Seam {
    const char* name;
    const char* grid;
    const char* rings;
    const char* zone;
    double area_m2;
};
void PrintTo(const Seam& seam, std::ostream* out) {
    *out << seam.name;
}

class AcrossASeam : public TinyScene, public ::testing::WithParamInterface<Seam> {};

TEST_P(AcrossASeam, ASceneIsOnePiece) {
    const Seam& seam = GetParam();
    // 0.00005 degree cells, 80 x 60.
    write("degrees.asc", slope_grid(seam.grid, 80, 60, 2));
    write("seam.geojson", polygon_geojson(seam.rings));
    write_scene(k_numbers_only);
    ran("result",
        {"time.end=0.1", "terrain.dtm=degrees.asc", "terrain.dtm-crs=EPSG:4326", "release.perimeter=seam.geojson"});
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NE(json_text(summary, "crs").find(seam.zone), std::string::npos) << summary;
    // 2 m thick; areas below are to a part in a thousand, UTM's scale included.
    EXPECT_NEAR(json_number(summary, "initial_m3") / (2 * seam.area_m2), 1, 1e-3);
    EXPECT_NE(read_text(path("result/log.txt")).find("resampling"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Seams, AcrossASeam,
    ::testing::Values(
        // 0.001 by 0.0005 degrees. On the ellipsoid 77.463 m by 55.576 m at 46 N, times the square of UTM's
        // scale 3 degrees off the central meridian, 0.9996 (1 + (0.05236 cos 46)^2 / 2) = 1.00026.
        Seam{"zones_32_and_33", "xllcorner 11.998\nyllcorner 45.9985\ncellsize 0.00005",
             "[[[11.9995, 46], [12.0005, 46], [12.0005, 46.0005], [11.9995, 46.0005], [11.9995, 46]]]", "UTM zone 3",
             77.463 * 55.576 * 1.00026 * 1.00026},
        // Split at the antimeridian as GeoJSON requires; at 16.5 S 106.764 m by 55.332 m, scale 1.00087.
        Seam{"antimeridian", "xllcorner 179.998\nyllcorner -16.5015\ncellsize 0.00005",
             "[[[179.9995, -16.5], [180, -16.5], [180, -16.4995], [179.9995, -16.4995], [179.9995, -16.5]]], "
             "[[[-180, -16.5], [-179.9995, -16.5], [-179.9995, -16.4995], [-180, -16.4995], [-180, -16.5]]]",
             "UTM zone", 106.764 * 55.332 * 1.00087 * 1.00087}),
    [](const auto& tested) { return tested.param.name; });

TEST_F(Input, InputsLeaveTheirFolderUnchanged) {
    const std::vector<std::string> square{
        "POLYGON((527020 5094055,527070 5094055,527070 5094095,527020 5094095,527020 5094055))"};
    std::filesystem::create_directory(folder_ / "in");
    gis::test::make_vector(path("in/a.gml"), "GML", "EPSG:32632", square);
    std::filesystem::remove(folder_ / "in/a.xsd");
    gis::test::make_vector(path("in/a.gpkg"), "GPKG", "EPSG:32632", square);
    gis::test::make_vector(path("in/a.shp"), "ESRI Shapefile", "EPSG:32632", square);
    write_dtm({}, true, "in/dtm.asc");
    const std::vector<std::string> before = files();
    const std::vector<std::string> keys{
        "terrain.dtm=in/dtm.asc", "release.perimeter=in/a.gml", "scar.perimeter=in/a.gpkg", "scar.deposit=in/a.shp",
        "output.maps=off",        "output.animation=off",       "output.frames=off"};
    for (const std::string command : {"check", "run"}) {
        std::vector<std::string> arguments = with_sets({command, "scene.ini"}, keys);
        if (command == "run") arguments.insert(arguments.end(), {"--out", path("result")});
        succeeded(frana(arguments));
        std::filesystem::remove_all(folder_ / "result");
        EXPECT_EQ(files(), before) << command;
    }
}

TEST_F(Input, OfAHugeDtmOnlyTheNeededPartIsRead) {
    // 20 000 x 20 000 cells of 2 m, 1.6 GB if it were read; the ground is in the south-eastern corner, the rest was
    // never written and is no data.
    constexpr int n = 20000;
    {
        const gis::GdalSession session;
        const char* options[] = {"SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE", nullptr};
        const GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            path("huge.tif").c_str(), n, n, 1, GDT_Float32, const_cast<char**>(options)));
        ASSERT_TRUE(file);
        double geo[6] = {k_west + 2000 - 2.0 * n, 2, 0, k_south - 1000 + 2.0 * n, 0, -2};
        file->SetGeoTransform(geo);
        OGRSpatialReference utm;
        utm.importFromEPSG(32632);
        file->SetSpatialRef(&utm);
        file->GetRasterBand(1)->SetNoDataValue(-9999);
        constexpr int corner = 2000;
        std::vector<float> row(corner);
        for (int column = 0; column < corner; ++column)
            row[static_cast<std::size_t>(column)] = 1500 - 0.6F * static_cast<float>(column);
        for (int k = 0; k < corner; ++k) {
            ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, n - corner, n - corner + k, corner, 1, row.data(),
                                                       corner, 1, GDT_Float32, 0, 0),
                      CE_None);
        }
    }
    for (const std::string bounds : {"", "526500 5093500 528500 5095000"}) {
        std::vector<std::string> scene{
            "check", "scene.ini", "--set", "terrain.dtm=huge.tif", "--set", "material.friction-angle=20"};
        if (!bounds.empty()) scene.insert(scene.end(), {"--set", "terrain.bounds=" + bounds});
        const Outcome outcome = succeeded(frana(scene));
        // The limit of 500 MB, for everything up to the engine; it includes the engine's trial by check.
        if (!k_sanitized) {
            EXPECT_LT(outcome.peak_memory_bytes, 500e6) << bounds;
        }
        expect_words(outcome.out, {"20 000 x 20 000"});
    }
    write_scene(k_numbers_only);
    ran("result", {"time.end=0.1", "terrain.dtm=huge.tif", "material.friction-angle=20", "output.extent=map"});
    EXPECT_EQ(gis::read_result_raster(path("result/dtm.tif")).grid.columns, 20'000);
    expect_words(read_text(path("result/log.txt")), {"elevations are read where the release lies"});
}

}  // namespace
}  // namespace frana::test
