// SPDX-License-Identifier: Apache-2.0
// Memory and time follow the flow, not the map: 20 000 x 20 000 cells, of which two flows 12 km apart reach a few
// thousand, in under a gigabyte with all maps and frames; and the numbers of a flow are those that a small map gives.
#include "large_map.h"

namespace frana::test {
namespace {

TEST_F(LargeMap, TwoFlowsFarApartTakeLessThanAGigabyte) {
    const std::vector<Place> hills{{4000, 4000}, {12485, 12485}};  // 12.0 km
    write_map("large.tif", 20'000, k_map_west, k_map_north, hills);
    write_releases(hills);
    write_scene("[output]\nanimation = off\n");
    const Outcome outcome = succeeded(run("large.tif", "result"));
    if (!k_sanitized) {
        EXPECT_LT(outcome.peak_memory_bytes, 1e9);
    }
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NEAR(json_number(summary, "initial_m3"), 40'000, 40);
    // Of each of the two, not from one to the other: from the hill's top to beyond a corner of 100 m x 100 m.
    EXPECT_GT(json_number(summary, "horizontal_m"), 70);
    EXPECT_LT(json_number(summary, "horizontal_m"), 150);
    EXPECT_EQ(Json::parse(summary)["flows"].size(), 2);
    const Raster depth = gis::read_result_raster(path("result/max_depth.tif"));
    EXPECT_EQ(depth.grid.columns, 20'000);
    std::int64_t reached[2] = {0, 0}, elsewhere = 0;
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        if (!(value > 0)) return;
        const auto row = static_cast<std::int64_t>(cell) / 20'000, column = static_cast<std::int64_t>(cell) % 20'000;
        bool near = false;
        for (int k = 0; k < 2; ++k) {
            const bool here = std::hypot(row - hills[k].row, column - hills[k].column) < k_hill;
            reached[k] += here;
            near = near || here;
        }
        elsewhere += !near;
    });
    EXPECT_GT(reached[0], 10'000);
    EXPECT_NEAR(static_cast<double>(reached[0]), static_cast<double>(reached[1]),
                0.01 * static_cast<double>(reached[0]));
    EXPECT_EQ(elsewhere, 0);
    for (const char* file : {"result/max_depth.tif", "result/dtm.tif", "result/frames/depth_0001.tif"})
        EXPECT_LT(std::filesystem::file_size(path(file)), 2e6) << file;
    const Outcome drawn = succeeded(frana({"render", "result", "--map", "max_depth", "--out", "maps"}));
    if (!k_sanitized) {
        EXPECT_LT(drawn.peak_memory_bytes, 1e9);
    }
}

// The maps of a study are those of its flows too, in several bands, and 0 where no member came.
TEST_F(LargeMap, AStudyOfTwoFlowsFarApartTakesLessThanAGigabyte) {
    const std::vector<Place> hills{{4000, 4000}, {12485, 12485}};
    write_map("dtm.tif", 20'000, k_map_west, k_map_north, hills);
    write_releases(hills, 18);
    write("scene.ini",
          "[terrain]\ndtm = dtm.tif\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "friction-angle = 8\nturbulence = 500\n[time]\nend = 3\n" +
              k_numbers_only + "depth-thresholds = 0.5\nvelocity-thresholds = 5\n");
    write("study.ini", "[study]\nscene = scene.ini\nsamples = 2\n[vary]\nmaterial.friction-angle = uniform(5, 12)\n");
    const Outcome outcome = succeeded(frana({"ensemble", "study.ini", "--out", "range", "--quiet"}));
    if (!k_sanitized) {
        EXPECT_LT(outcome.peak_memory_bytes, 1e9);
    }
    const Raster probability = gis::read_result_raster(path("range/probability_depth_0.5.tif"));
    EXPECT_GT(probability.grid.columns, 8'000);
    const auto at = [&](double column, double row) {
        const double x = k_map_west + column - probability.grid.west, y = probability.grid.north - (k_map_north - row);
        return probability.at(static_cast<std::int64_t>(y), static_cast<std::int64_t>(x));
    };
    for (const Place& hill : hills) EXPECT_EQ(at(hill.column, hill.row), 1);
    EXPECT_EQ(at(8000, 8000), 0);
    EXPECT_LT(std::filesystem::file_size(path("range/probability_depth_0.5.tif")), 1e6);
    EXPECT_LT(std::filesystem::file_size(path("range/dtm.tif")), 1e6);
}

TEST_F(LargeMap, ShowsWhatWasReachedUnlessAskedForTheMap) {
    const std::vector<Place> hill{{9123, 7321}};
    write_map("large.tif", 20'000, k_map_west, k_map_north, hill);
    write_releases(hill, 18);
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "bed-friction = manning\nmanning = 0.1\n[time]\nend = 3\n[output]\nanimation = off\nmaps = off\nreport = "
          "off\n");
    for (const char* extent : {"auto", "map"}) {
        succeeded(run("large.tif", extent, extent));
    }
    for (const char* file : {"max_depth", "final_depth", "dtm", "bed", "frames/velocity_0001"}) {
        const Raster part = gis::read_result_raster(path("auto/" + std::string(file) + ".tif")),
                     whole = gis::read_result_raster(path("map/" + std::string(file) + ".tif"));
        EXPECT_EQ(whole.grid.columns, 20'000);
        EXPECT_LT(part.grid.columns, 400) << file;
        const auto down = std::llround(whole.grid.north - part.grid.north),
                   right = std::llround(part.grid.west - whole.grid.west);
        std::int64_t values = 0;
        for (std::int64_t row = 0; row < part.grid.rows; ++row) {
            for (std::int64_t column = 0; column < part.grid.columns; ++column) {
                const double a = part.at(row, column), b = whole.at(row + down, column + right);
                values += !std::isnan(a);
                ASSERT_TRUE(a == b || std::isnan(b)) << file << " " << row << " " << column;
            }
        }
        EXPECT_GT(values, 1000) << file;
    }
}

TEST_F(SameBits, WithARasterOfThicknesses) {
    write_maps();
    write_round_top("thickness.tif", dome);
    for (const char* perimeter : {"perimeter = perimeter.geojson\n", ""}) {
        write_fluid_scene(std::string(perimeter) + "thickness = raster:thickness.tif");
        expect_same_flow();
        for (const char* result : {"large", "small"}) std::filesystem::remove_all(path(result));
    }
}

TEST_F(SameBits, WithADifferenceOfElevations) {
    write_maps();
    write_round_top("before.tif", [](double cells) { return 60 - 0.4 * cells; });
    write_round_top("after.tif", [](double cells) { return 60 - 0.4 * cells - dome(cells); });
    write_fluid_scene(
        "perimeter = perimeter.geojson\nthickness = difference:before.tif,after.tif\ndtm-contains-release = on");
    expect_same_flow();
}

TEST_F(SameBits, WithSlipSurfacesReadAndFitted) {
    write_maps();
    write_round_top("slip.tif", [](double cells) { return 60 - 0.4 * cells - dome(cells); });
    write_fluid_scene("perimeter = perimeter.geojson\nthickness = slip-surface:slip.tif\ndtm-contains-release = on");
    expect_same_flow();
    for (const char* result : {"large", "small"}) std::filesystem::remove_all(path(result));
    write_fluid_scene(
        "perimeter = perimeter.geojson\nthickness = slip-surface\nslip-depth = 4\ndtm-contains-release = on");
    expect_same_flow();
}

TEST_F(SameBits, WithValuesByPlaceAndAnErodibleBed) {
    write_maps();
    write_round_top("rough.tif", [](double cells) { return 0.05 + 0.001 * cells; });
    // The southern half of the hill is another zone.
    const double west = k_map_west + k_top.column - 200, middle = k_map_north - k_top.row;
    const auto corner = [](double x, double y) { return "[" + std::to_string(x) + "," + std::to_string(y) + "]"; };
    write("zones.geojson",
          R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},"features":[)"
          R"({"type":"Feature","properties":{"depth":0.4},"geometry":{"type":"Polygon","coordinates":[[)" +
              corner(west, middle) + "," + corner(west + 400, middle) + "," + corner(west + 400, middle - 200) + "," +
              corner(west, middle - 200) + "," + corner(west, middle) + "]]}}]}");
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\nfriction-zones = zones.geojson\n[release]\nperimeter = perimeter.geojson\n"
          "thickness = 2\n[material]\nbed-friction = coulomb manning\nmanning = 0.1\nfriction-angle = 3\n[zones]\n"
          "erodible-depth = attribute:depth\nfriction-coefficient = raster:rough.tif\n[entrainment]\n"
          "erosion = growth\ngrowth-rate = 0.02\nerodible-depth = 0.1\n[time]\nend = 3\n" +
              k_numbers_only);
    expect_same_flow();
    expect_same("eroded_depth");
}

TEST_F(SameBits, WithAFrictionTable) {
    write_maps();
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "friction-table = ngi-avalanche\nreturn-period = 300\ntable-friction-factor = 0.2\n[time]\nend = 3\n" +
              k_numbers_only);
    expect_same_flow();
}

// Holes in the hill, among them one wider than is filled.
TEST_F(SameBits, WithHolesThatAreFilled) {
    write_maps();
    for (const char* map : {"large.tif", "small.tif"}) {
        const gis::GdalSession session;
        const GDALDatasetUniquePtr file(GDALDataset::Open(path(map).c_str(), GDAL_OF_UPDATE | GDAL_OF_RASTER));
        ASSERT_TRUE(file);
        GDALRasterBand* const band = file->GetRasterBand(1);
        const bool large = band->GetXSize() > k_small;
        const auto hole = [&](int east, int south, int side) {
            std::vector<float> nothing(static_cast<std::size_t>(side * side), -9999.0F);
            const int column = k_top.column + east - (large ? 0 : k_column),
                      row = k_top.row + south - (large ? 0 : k_row);
            return band->RasterIO(GF_Write, column, row, side, side, nothing.data(), side, side, GDT_Float32, 0, 0);
        };
        ASSERT_EQ(hole(15, -20, 30), CE_None);
        ASSERT_EQ(hole(-90, 10, 25), CE_None);
        ASSERT_EQ(hole(-30, 150, 130), CE_None);
    }
    write_fluid_scene("perimeter = perimeter.geojson\nthickness = 2",
                      "[terrain]\nnodata-policy = fill\nnodata-value = -9999\n");
    expect_same_flow();
    for (const char* raster : {"dtm", "bed"}) {
        const Raster large = gis::read_result_raster(path("large/" + std::string(raster) + ".tif")),
                     small = gis::read_result_raster(path("small/" + std::string(raster) + ".tif"));
        std::int64_t same = 0;
        for (std::int64_t row = 0; row < k_small; ++row)
            for (std::int64_t column = 0; column < k_small; ++column) {
                const double a = large.at(row + k_row, column + k_column);
                if (std::isnan(a)) continue;
                ASSERT_EQ(a, small.at(row, column)) << raster << " " << row << " " << column;
                ++same;
            }
        EXPECT_GT(same, 20'000) << raster;
    }
}

// A mosaic that is empty but for one valley, as all samples of it are.
TEST_F(SameBits, WhereAlmostNothingOfTheMapHasData) {
    write_maps();
    {
        const gis::GdalSession session;
        const GDALDatasetUniquePtr file(GDALDataset::Open(path("large.tif").c_str(), GDAL_OF_UPDATE | GDAL_OF_RASTER));
        ASSERT_TRUE(file);
        file->GetRasterBand(1)->SetNoDataValue(-9999);  // which blocks that were left out then read as
    }
    write_fluid_scene("perimeter = perimeter.geojson\nthickness = 2");
    expect_same_flow();
}

// ulimit -v counts addresses, also of ground that nothing reaches.
TEST_F(LargeMap, AsksForAddressesThatTheShellAllows) {
    const std::vector<Place> hills{{4000, 4000}, {12485, 12485}};
    write_map("large.tif", 20'000, k_map_west, k_map_north, hills);
    write_releases(hills);
    write_scene(k_numbers_only);
    const std::string command = "cd '" + folder_.string() + "' && ulimit -v 20000000 && '" + FRANA_PROGRAM +
                                "' check scene.ini --set terrain.dtm=large.tif > out.txt 2> err.txt";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
    const std::string err = read_text(path("err.txt"));
    expect_words(err, {"terrain.cell-size", "addresses", "ulimit -v"});
}

}  // namespace
}  // namespace frana::test
