// SPDX-License-Identifier: Apache-2.0
#include "sample_data/samples.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "core/error.h"
#include "core/files.h"
#include "core/raster.h"
#include "core/text.h"
#include "gis/raster/raster_out.h"

namespace frana::sample {
void write_text(const std::string& path, const std::string& text) {
    FileAside file(path);
    std::ofstream stream(file.partial_path(), std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) throw Error(ErrorKind::environment, Problem{"cannot be written", path, "", "", "Check the folder"});
    file.rename_into_place();
}

namespace {

double tangent(double degrees) {
    return std::tan(degrees * std::numbers::pi / 180);
}

// Writes ground as a north-up raster from the origin on; heights to 1e-6 of a cell.
void write_ground(const std::string& path, std::int64_t columns, std::int64_t rows, double cell_size,
                  const std::function<double(double, double)>& height) {
    GridSpec grid;
    grid.west = 0;
    grid.north = static_cast<double>(rows) * cell_size;
    grid.cell_size = cell_size;
    grid.columns = columns;
    grid.rows = rows;
    Raster raster(grid);
    const double unit = 1e-6 * cell_size;
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
            raster.at(row, column) = std::round(height((static_cast<double>(column) + 0.5) * cell_size,
                                                       grid.north - (static_cast<double>(row) + 0.5) * cell_size) /
                                                unit) *
                                     unit;
    gis::write_geotiff(path, raster,
                       {"dtm", "Ground of an experiment", "m", {{"ORIGIN", "Made by frana's sample generator"}}});
}

void write_rectangle(const std::string& path, double west, double south, double east, double north) {
    const auto corner = [](double x, double y) { return "[" + shortest_text(x) + ", " + shortest_text(y) + "]"; };
    write_text(path,
               "{\"type\": \"FeatureCollection\", \"crs\": null, \"features\": [{\"type\": \"Feature\", "
               "\"properties\": {}, \"geometry\": {\"type\": \"Polygon\", \"coordinates\": [[" +
                   corner(west, south) + ", " + corner(east, south) + ", " + corner(east, north) + ", " +
                   corner(west, north) + ", " + corner(west, south) + "]]}}]}\n");
}

std::string in(const std::string& folder, const char* name) {
    return (std::filesystem::path(folder) / name).string();
}

}  // namespace

void write_flume_sample(const std::string& folder) {
    constexpr double k_cell = 0.005, k_length = 2.7, k_block_front = 0.6, k_block_length = 0.3;
    constexpr double k_obstacle_length = 0.1, k_steep = 40, k_flat = 2;
    const double foot = (k_length - k_flume_break) * tangent(k_flat);
    write_ground(in(folder, "dtm.tif"), 540, 120, k_cell, [&](double x, double) {
        return x < k_flume_break ? foot + (k_flume_break - x) * tangent(k_steep) : (k_length - x) * tangent(k_flat);
    });
    const double plan = std::round(1e4 * k_block_length * std::cos(k_steep * std::numbers::pi / 180)) / 1e4;
    write_rectangle(in(folder, "block.geojson"), k_block_front - plan, k_block_south, k_block_front, k_block_north);
    write_rectangle(in(folder, "obstacle.geojson"), k_flume_break, k_block_south, k_flume_break + k_obstacle_length,
                    k_obstacle_north);
}

void write_fracture_sample(const std::string& folder) {
    constexpr double k_cell = 10, k_south = 200, k_north = 300, k_block = 200;
    // 15 degrees, from 400 m on 30 degrees, from 900 m on 3 degrees.
    write_ground(in(folder, "break_dtm.tif"), 190, 50, k_cell, [](double x, double) {
        const double foot = 1000 * tangent(3), middle = foot + 500 * tangent(30);
        if (x > 900) return (1900 - x) * tangent(3);
        return x > 400 ? foot + (900 - x) * tangent(30) : middle + (400 - x) * tangent(15);
    });
    write_rectangle(in(folder, "break_block.geojson"), 400 - k_block / 2, k_south, 400 + k_block / 2, k_north);
    // 30 degrees down to 700 m, 20 degrees up from there.
    write_ground(in(folder, "valley_dtm.tif"), 140, 50, k_cell,
                 [](double x, double) { return x > 700 ? (x - 700) * tangent(20) : (700 - x) * tangent(30); });
    write_rectangle(in(folder, "valley_block.geojson"), 200 - k_block / 2, k_south, 200 + k_block / 2, k_north);
}

void write_reservoir_sample(const std::string& folder) {
    constexpr double k_cell = 10, k_axis = 300, k_dam = 500, k_half_breach = 30;
    write_ground(in(folder, "dtm.tif"), 150, 60, k_cell, [](double x, double y) {
        constexpr double k_crest = 130, k_half_crest = 10;
        const double across = std::abs(y - k_axis), fall = 0.004 * (1500 - x);
        const double sides = 40 * std::min(1.0, std::pow(across / 250, 2)), end = 30 * std::max(0.0, 1 - x / 100);
        const double valley = 100 + fall + (sides + end) * std::clamp((600 - x) / 100, 0.0, 1.0);
        const double bumps = 0.3 * std::sin(x / 40) * std::cos(y / 30);
        const double dam = k_crest - std::max(0.0, std::abs(x - k_dam) - k_half_crest) / 2;
        return std::max(valley + bumps, across > k_half_breach ? dam : 0);
    });
    write_rectangle(in(folder, "lake.geojson"), 0, 0, k_dam, 2 * k_axis);
}

}  // namespace frana::sample
