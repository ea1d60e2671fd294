// SPDX-License-Identifier: Apache-2.0
// Memory and time follow the flow, not the map: 20 000 x 20 000 cells, of which two flows 12 km apart reach a few
// thousand, in under a gigabyte with all maps and frames; and the numbers of a flow are those that a small map gives.
#include <gdal_priv.h>

#include <cmath>
#include <utility>

#include "core/raster.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_in.h"
#include "tiny_scene.h"

namespace frana::test {
namespace {

constexpr double k_map_west = 500'000, k_map_north = 5'120'000;
constexpr int k_hill = 300;  // [cells], half of its side

struct Place {
    int column, row;
};

class LargeMap : public TinyScene {
  protected:
    // A plain of 1 m cells with cones of 60 m on it, whose slope is 0.4; blocks of the file without any are left out.
    void write_map(const std::string& name, int side, double west, double north,
                   const std::vector<Place>& hills) const {
        const gis::GdalSession session;
        const char* options[] = {"SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE", nullptr};
        const GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            path(name).c_str(), side, side, 1, GDT_Float32, const_cast<char**>(options)));
        ASSERT_TRUE(file);
        double geo[6] = {west, 1, 0, north, 0, -1};
        file->SetGeoTransform(geo);
        OGRSpatialReference utm;
        utm.importFromEPSG(32632);
        file->SetSpatialRef(&utm);
        std::vector<float> cells(4 * k_hill * k_hill);
        for (int row = 0; row < 2 * k_hill; ++row)
            for (int column = 0; column < 2 * k_hill; ++column)
                cells[static_cast<std::size_t>(2 * k_hill * row + column)] =
                    static_cast<float>(std::max(0.0, 60 - 0.4 * std::hypot(column + 0.5 - k_hill, row + 0.5 - k_hill)));
        for (const Place& hill : hills) {
            ASSERT_EQ(
                file->GetRasterBand(1)->RasterIO(GF_Write, hill.column - k_hill, hill.row - k_hill, 2 * k_hill,
                                                 2 * k_hill, cells.data(), 2 * k_hill, 2 * k_hill, GDT_Float32, 0, 0),
                CE_None);
        }
    }
    // Squares of 100 m on the hills' tops.
    void write_releases(const std::vector<Place>& hills) const {
        std::string parts;
        for (const Place& hill : hills) {
            const double x = k_map_west + hill.column, y = k_map_north - hill.row;
            const auto corner = [](double a, double b) {
                return "[" + std::to_string(a) + "," + std::to_string(b) + "]";
            };
            parts += std::string(parts.empty() ? "" : ",") + "[[" + corner(x - 50, y - 50) + "," +
                     corner(x + 50, y - 50) + "," + corner(x + 50, y + 50) + "," + corner(x - 50, y + 50) + "," +
                     corner(x - 50, y - 50) + "]]";
        }
        write("perimeter.geojson",
              R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},"features":[)"
              R"({"type":"Feature","properties":{"depth":2},"geometry":{"type":"MultiPolygon","coordinates":[)" +
                  parts + "]}}]}");
    }
    [[nodiscard]] Outcome run(const std::string& dtm, const std::string& result) const {
        const std::vector<std::string> words{"run",   "scene.ini",          "--out", result,      "--quiet",
                                             "--set", "terrain.dtm=" + dtm, "--set", "time.end=3"};
        return frana(words);
    }
};

TEST_F(LargeMap, TwoFlowsFarApartTakeLessThanAGigabyte) {
    const std::vector<Place> hills{{4000, 4000}, {12485, 12485}};  // 12.0 km
    write_map("large.tif", 20'000, k_map_west, k_map_north, hills);
    write_releases(hills);
    write_scene("[output]\nanimation = off\n");
    const Outcome outcome = run("large.tif", "result");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    if (!k_sanitized) {
        EXPECT_LT(outcome.peak_memory_bytes, 1e9);
    }
    const std::string summary = read_text(path("result/summary.json"));
    EXPECT_NEAR(json_number(summary, "initial_m3"), 40'000, 40);
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
    const Outcome drawn = frana({"render", "result", "--map", "max_depth", "--out", "maps"});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    if (!k_sanitized) {
        EXPECT_LT(drawn.peak_memory_bytes, 1e9);
    }
}

// Fluid without friction: no energy line bounds it, so the whole of the large map belongs to the scene.
TEST_F(LargeMap, GivesTheBitsOfASmallMapAround) {
    const std::vector<Place> hill{{9123, 7321}};
    write_map("large.tif", 20'000, k_map_west, k_map_north, hill);
    constexpr int small = 1200;
    const int column = hill[0].column - 700, row = hill[0].row - 500;
    write_map("small.tif", small, k_map_west + column, k_map_north - row, {{700, 500}});
    write_releases(hill);
    write("scene.ini",
          "[terrain]\ndtm = dtm.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "bed-friction = manning\nmanning = 0.1\n[time]\nend = 3\n" +
              k_numbers_only);
    for (const char* name : {"large", "small"}) {
        const Outcome outcome = run(std::string(name) + ".tif", name);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    EXPECT_EQ(read_text(path("large/timeseries.csv")), read_text(path("small/timeseries.csv")));
    for (const char* raster : {"max_depth", "max_velocity", "arrival_time", "final_depth", "release"}) {
        const Raster large = gis::read_result_raster(path("large/" + std::string(raster) + ".tif")),
                     part = gis::read_result_raster(path("small/" + std::string(raster) + ".tif"));
        ASSERT_EQ(part.grid.columns, small);
        ASSERT_EQ(large.grid.columns, 20'000);
        std::int64_t values = 0, all = 0;
        for (std::int64_t r = 0; r < small; ++r) {
            for (std::int64_t c = 0; c < small; ++c) {
                const double a = part.at(r, c), b = large.at(r + row, c + column);
                values += !std::isnan(a);
                ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << raster << " " << r << " " << c;
            }
        }
        large.values.for_each_stored([&](std::size_t, double value) { all += !std::isnan(value); });
        EXPECT_EQ(values, all) << raster;
        EXPECT_GT(values, 5000);
    }
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
    for (const char* word : {"terrain.cell-size", "addresses", "ulimit -v"})
        EXPECT_NE(err.find(word), std::string::npos) << err;
}

}  // namespace
}  // namespace frana::test
