// SPDX-License-Identifier: Apache-2.0
// Maps of 20 000 x 20 000 cells with hills on them, and the same hills on small maps.
#pragma once

#include <gdal_priv.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/json.h"
#include "core/raster.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_in.h"
#include "support/tiny_scene.h"

namespace frana::test {

inline constexpr double k_map_west = 500'000, k_map_north = 5'120'000;
inline constexpr int k_hill = 300;  // [cells], half of its side

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
    // Squares on the hills' tops.
    void write_releases(const std::vector<Place>& hills, double half_side = 50) const {
        std::string parts;
        for (const Place& hill : hills) {
            const double x = k_map_west + hill.column, y = k_map_north - hill.row, h = half_side;
            const auto corner = [](double a, double b) {
                return "[" + std::to_string(a) + "," + std::to_string(b) + "]";
            };
            parts += std::string(parts.empty() ? "" : ",") + "[[" + corner(x - h, y - h) + "," + corner(x + h, y - h) +
                     "," + corner(x + h, y + h) + "," + corner(x - h, y + h) + "," + corner(x - h, y - h) + "]]";
        }
        write("perimeter.geojson",
              R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},"features":[)"
              R"({"type":"Feature","properties":{"depth":2},"geometry":{"type":"MultiPolygon","coordinates":[)" +
                  parts + "]}}]}");
    }
    [[nodiscard]] Outcome run(const std::string& dtm, const std::string& result, const std::string& extent = "map",
                              double end = 3) const {
        const std::vector<std::string> words{"run",
                                             "scene.ini",
                                             "--out",
                                             result,
                                             "--quiet",
                                             "--set",
                                             "terrain.dtm=" + dtm,
                                             "--set",
                                             "time.end=" + std::to_string(end),
                                             "--set",
                                             "output.extent=" + extent};
        return frana(words);
    }
};

// Fluid without friction: no energy line bounds it, so the whole of the large map belongs to the scene.
class SameBits : public LargeMap {
  protected:
    static constexpr int k_small = 1200, k_column = 8423, k_row = 6821;  // of the small map in the large one
    static constexpr Place k_top{9123, 7321};
    static constexpr double k_half_side = 18;      // of the release [m]
    static constexpr std::int64_t k_least = 1000;  // cells with values

    void write_maps() const {
        write_map("large.tif", 20'000, k_map_west, k_map_north, {k_top});
        write_map("small.tif", k_small, k_map_west + k_column, k_map_north - k_row,
                  {{k_top.column - k_column, k_top.row - k_row}});
        write_releases({k_top}, k_half_side);
    }
    void write_fluid_scene(const std::string& release, const std::string& more = "") const {
        write("scene.ini", "[terrain]\ndtm = dtm.asc\n[release]\n" + release +
                               "\n[material]\nbed-friction = manning\nmanning = 0.1\n[time]\nend = 3\n" +
                               k_numbers_only + more);
    }
    /// @param structured lines of its section
    void write_structured_scene(const std::string& release, const std::string& structured) const {
        write("scene.ini", "[terrain]\ndtm = dtm.asc\n[release]\n" + release +
                               "\n[material]\nmodel = structured\n[structured]\n" + structured +
                               "\n[numerics]\nparticles-per-cell = 9\n[time]\nend = 3\n" + k_numbers_only);
    }
    /// A raster of 300 x 300 cells round the top: `value` of the distance from it [cells].
    void write_round_top(const std::string& name, const std::function<double(double)>& value) const {
        constexpr int k_side = 300;
        const gis::GdalSession session;
        const GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            path(name).c_str(), k_side, k_side, 1, GDT_Float32, nullptr));
        ASSERT_TRUE(file);
        double geo[6] = {k_map_west + k_top.column - k_side / 2, 1, 0, k_map_north - k_top.row + k_side / 2, 0, -1};
        file->SetGeoTransform(geo);
        OGRSpatialReference utm;
        utm.importFromEPSG(32632);
        file->SetSpatialRef(&utm);
        std::vector<float> cells(k_side * k_side);
        for (int row = 0; row < k_side; ++row)
            for (int column = 0; column < k_side; ++column)
                cells[static_cast<std::size_t>(k_side * row + column)] =
                    static_cast<float>(value(std::hypot(column + 0.5 - k_side / 2, row + 0.5 - k_side / 2)));
        ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, k_side, k_side, cells.data(), k_side, k_side,
                                                   GDT_Float32, 0, 0),
                  CE_None);
    }
    static double dome(double cells) { return std::max(0.0, 3 - 0.125 * cells); }
    void run_both(double end) const {
        for (const char* name : {"large", "small"}) {
            const Outcome outcome = succeeded(run(std::string(name) + ".tif", name, "map", end));
            if (!k_sanitized) {
                EXPECT_LT(outcome.peak_memory_bytes, 1e9) << name;
            }
        }
        EXPECT_EQ(read_text(path("large/timeseries.csv")), read_text(path("small/timeseries.csv")));
    }
    void expect_same(const std::string& raster, std::int64_t least = k_least) const {
        const Raster large = gis::read_result_raster(path("large/" + raster + ".tif")),
                     part = gis::read_result_raster(path("small/" + raster + ".tif"));
        ASSERT_EQ(part.grid.columns, k_small);
        ASSERT_EQ(large.grid.columns, 20'000);
        std::int64_t values = 0, all = 0;
        for (std::int64_t r = 0; r < k_small; ++r) {
            for (std::int64_t c = 0; c < k_small; ++c) {
                const double a = part.at(r, c), b = large.at(r + k_row, c + k_column);
                values += !std::isnan(a);
                ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << raster << " " << r << " " << c;
            }
        }
        large.values.for_each_stored([&](std::size_t, double value) { all += !std::isnan(value); });
        EXPECT_EQ(values, all) << raster;
        EXPECT_GT(values, least) << raster;
    }
    void expect_same_flow(double end = 3) const {
        run_both(end);
        for (const char* raster : {"max_depth", "max_velocity", "arrival_time", "final_depth", "release"})
            expect_same(raster);
    }
};

}  // namespace frana::test
