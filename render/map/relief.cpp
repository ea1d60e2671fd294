// SPDX-License-Identifier: Apache-2.0
#include "render/map/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/module.h"
#include "render/canvas/furniture.h"
#include "render/map/legend.h"
#include "render/map/map_body.h"

namespace frana::render {
namespace {

struct Light {
    double azimuth_deg;  ///< direction of the light, clockwise from north
    double elevation_deg;
    double weight;
};

/// The main light is in the north-west, as viewers expect; the others show slopes parallel to it.
constexpr std::array<Light, 4> k_lights{{{315, 42, 0.55}, {270, 45, 0.17}, {0, 45, 0.17}, {225, 50, 0.11}}};

}  // namespace

Raster hillshade(const Raster& terrain) {
    const GridSpec& grid = terrain.grid;
    Raster shade(grid, k_no_data);
    struct Direction {
        double east, north, up;
    };
    std::array<Direction, k_lights.size()> lights{};
    for (std::size_t i = 0; i < k_lights.size(); ++i) {
        const double azimuth = k_lights[i].azimuth_deg * std::numbers::pi / 180;
        const double elevation = k_lights[i].elevation_deg * std::numbers::pi / 180;
        const double weight = k_lights[i].weight;
        lights[i] = {weight * std::cos(elevation) * std::sin(azimuth), weight * std::cos(elevation) * std::cos(azimuth),
                     weight * std::sin(elevation)};
    }
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const double here = terrain.at(row, column);
            if (std::isnan(here)) continue;
            // Differences over the existing neighbours: central inside, one-sided along edges and gaps.
            const auto slope = [&](std::int64_t r0, std::int64_t c0, std::int64_t r1, std::int64_t c1) {
                const auto value = [&](std::int64_t r, std::int64_t c) {
                    const bool outside = r < 0 || c < 0 || r >= grid.rows || c >= grid.columns;
                    return outside ? k_no_data : terrain.at(r, c);
                };
                const double before = value(r0, c0), after = value(r1, c1);
                const bool has_before = !std::isnan(before), has_after = !std::isnan(after);
                if (!has_before && !has_after) return 0.0;
                const double length = grid.cell_size * ((has_before ? 1 : 0) + (has_after ? 1 : 0));
                return ((has_after ? after : here) - (has_before ? before : here)) / length;
            };
            const double to_east = slope(row, column - 1, row, column + 1);
            const double to_north = slope(row + 1, column, row - 1, column);
            const double length = std::sqrt(1 + to_east * to_east + to_north * to_north);
            double sum = 0;
            for (const Direction& light : lights) {
                sum += std::max(0.0, (light.up - to_east * light.east - to_north * light.north) / length);
            }
            shade.at(row, column) = std::min(sum, 1.0);
        }
    }
    return shade;
}

std::vector<Contour> contour_lines(const Raster& raster, double interval) {
    const GridSpec& grid = raster.grid;
    const ValueRange range = value_range(raster);
    if (range.empty()) return {};
    const std::vector<double> values(raster.values.begin(), raster.values.end());
    const auto lines = call_module([&] {
        return vtk().level_lines(values, static_cast<int>(grid.columns), static_cast<int>(grid.rows),
                                 multiples(range.least, range.greatest, interval));
    });
    std::vector<Contour> contours;
    for (const std::vector<ScenePoint>& line : lines) {
        bool goes_on = false;
        for (const ScenePoint& p : line) {
            if (std::isnan(p.x) || std::isnan(p.y)) {  // beside a gap
                goes_on = false;
                continue;
            }
            if (!goes_on) contours.push_back({p.z, {}});
            goes_on = true;
            contours.back().points.push_back(
                {grid.west + (p.x + 0.5) * grid.cell_size, grid.north - (p.y + 0.5) * grid.cell_size});
        }
    }
    std::erase_if(contours, [](const Contour& contour) { return contour.points.size() < 2; });
    return contours;
}

}  // namespace frana::render
