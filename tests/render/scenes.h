// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "core/geometry.h"
#include "core/raster.h"
#include "render/canvas/image.h"
#include "render/map/map2d.h"

namespace frana::render::test {

/// A slope of 0.4 falling to the south into a level valley, with gentle ribs; 120 x 100 cells of 10 m.
inline Raster terrain() {
    Raster raster(GridSpec{527000, 5095000, 10, 120, 100, "a projected CRS"});
    for (std::int64_t row = 0; row < raster.grid.rows; ++row) {
        for (std::int64_t column = 0; column < raster.grid.columns; ++column) {
            const Point p = raster.grid.local_from_map(raster.grid.cell_centre(row, column));
            raster.at(row, column) = 600 + 0.4 * std::max(0.0, p.y - 200) + 6 * std::sin(p.x / 60);
        }
    }
    return raster;
}

/// A tongue down the middle of that slope: depths 0 to `deepest`, NaN around it.
inline Raster tongue(double deepest = 9.5) {
    Raster raster(terrain().grid, k_no_data);
    for (std::int64_t row = 20; row < 85; ++row) {
        for (std::int64_t column = 50; column < 70; ++column) {
            const double across = 1 - std::pow((static_cast<double>(column) - 59.5) / 10.5, 2);
            const double along = std::sin(std::numbers::pi * (static_cast<double>(row) - 19) / 67);
            raster.at(row, column) = deepest * across * along;
        }
    }
    return raster;
}

inline MultiPolygon square(Point centre, double half) {
    return {Polygon{{{centre.x - half, centre.y - half},
                     {centre.x + half, centre.y - half},
                     {centre.x + half, centre.y + half},
                     {centre.x - half, centre.y + half}},
                    {}}};
}

/// A map with all elements. The rasters must outlive it.
inline MapSpec full_map(const Raster& ground, const Raster& layer, int width, int height) {
    MapSpec spec;
    spec.title = "Maximum flow depth";
    spec.subtitle = "Scenario “test” · ξ = 200 m/s² · φ = 34°";
    spec.legend_title = "Maximum depth";
    spec.unit = "m";
    spec.attribution = "frana";
    spec.crs_label = "EPSG:32632 (WGS 84 / UTM zone 32N)";
    spec.terrain = &ground;
    spec.layer = &layer;
    spec.outlines = {{"Release", square({527600, 5094700}, 80), {200, 20, 30}, 2.5, true},
                     {"Surveyed scar", square({527600, 5094500}, 200), {20, 40, 160}, 2.5, false}};
    spec.side_notes = {"Volume: 1 200 000 m³", "Reach angle: 21.3°"};
    spec.convergence_deg = 0.27;
    spec.width = width;
    spec.height = height;
    return spec;
}

/// Degrees of an invented projection: a thousandth of a degree for 80 m to the east, 110 m to the north, slightly
/// sheared.
inline Point degrees_at(Point map) {
    const double x = map.x - 527000, y = map.y - 5094000;
    return {9.35 + x / 80e3 + y / 4e6, 46.0 + y / 110e3 - x / 5e6};
}

/// The same with places, lines and coordinates in degrees as well.
inline MapSpec crowded_map(const Raster& ground, const Raster& layer, int width, int height) {
    MapSpec spec = full_map(ground, layer, width, height);
    spec.source = "max_depth.tif, band 1";
    Outline gauges{"Gauges", {}, {150, 0, 60}, 2, false, {}, {}};
    gauges.places = {{"bridge", {527560, 5094300}}, {"road", {527680, 5094620}}, {"church", {527400, 5094450}}};
    Outline sections{"Cross-sections", {}, {70, 50, 120}, 2, false, {}, {}};
    sections.lines = {{{527450, 5094400}, {527760, 5094420}}};
    spec.outlines.push_back(gauges);
    spec.outlines.push_back(sections);
    spec.longitude_latitude = degrees_at;
    spec.window = Bounds{527350, 5094150, 527850, 5094850};
    return spec;
}

/// Returns the pixel of a map point.
inline std::pair<int, int> pixel(const MapLayout& layout, Point map) {
    return {static_cast<int>(layout.map.left + (map.x - layout.window.west) / layout.metres_per_pixel),
            static_cast<int>(layout.map.top + (layout.window.north - map.y) / layout.metres_per_pixel)};
}

inline bool near(Rgb a, Rgb b, int tolerance) {
    return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance && std::abs(a.b - b.b) <= tolerance;
}

/// A colour of a palette as the legend has it.
inline Rgb in_legend(Rgb pure) {
    const auto light = [](int byte) { return static_cast<std::uint8_t>(std::lround(byte + 0.2 * (255 - byte))); };
    return {light(pure.r), light(pure.g), light(pure.b)};
}

/// Whether a pixel has a colour of the legend, lighter or darker by the ground below.
inline bool shows(Rgb pixel, Rgb legend) {
    // From the darkest channel: brighter ones may be full.
    const auto [from, to] =
        std::min({std::pair<int, int>{legend.r, pixel.r}, {legend.g, pixel.g}, {legend.b, pixel.b}});
    const double light = static_cast<double>(to) / from;
    const auto scaled = [&](int byte) { return static_cast<std::uint8_t>(std::min(255.0, std::round(byte * light))); };
    return light > 0.6 && light < 1.26 && near(pixel, {scaled(legend.r), scaled(legend.g), scaled(legend.b)}, 5);
}

/// A separate folder for each test, removed with its contents.
class Folder {
  public:
    explicit Folder(const std::string& name)
        : path_(std::filesystem::temp_directory_path() / ("frana_render_" + name + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator{}));
    }

  private:
    std::filesystem::path path_;
};

}  // namespace frana::render::test
