// SPDX-License-Identifier: Apache-2.0
#include "simulation/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/archive.h"

namespace frana {
namespace {

constexpr double k_none = std::numeric_limits<double>::infinity();

// South-western corner in map coordinates; infinite if there is nothing.
Point corner_of(const Scene& scene) {
    Point corner{k_none, k_none};
    const auto include = [&](Point p) {
        corner.x = std::min(corner.x, p.x);
        corner.y = std::min(corner.y, p.y);
    };
    for (const ReleaseArea& area : scene.release)
        for (const Polygon& polygon : area.outline) std::for_each(polygon.outer.begin(), polygon.outer.end(), include);
    for (const Inflow& inflow : scene.inflows) std::for_each(inflow.line.begin(), inflow.line.end(), include);
    if (!scene.structured || !scene.structured->initial_fluid) return corner;
    const Raster& fluid = *scene.structured->initial_fluid;
    fluid.values.for_each_stored([&](std::size_t cell, double depth) {
        const auto n = static_cast<std::int64_t>(cell);
        if (depth > 0) include(scene.grid.cell_centre(n / scene.grid.columns, n % scene.grid.columns));
    });
    return corner;
}

}  // namespace

void place_origin(Scene& scene) {
    GridSpec& grid = scene.grid;
    const Point corner = corner_of(scene);
    const auto cell = [&](double distance, std::int64_t count) {
        if (!std::isfinite(distance)) return std::int64_t{0};
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(distance / grid.cell_size)), 0, count - 1);
    };
    put_origin(scene, {cell(corner.x - grid.west, grid.columns), cell(corner.y - grid.south(), grid.rows)});
}

void put_origin(Scene& scene, OriginCell cell) {
    GridSpec& grid = scene.grid;
    StateReader::require(cell.column >= 0 && cell.column < grid.columns && cell.row >= 0 && cell.row < grid.rows);
    grid.origin_column = cell.column;
    grid.origin_row = cell.row;
    scene.terrain.grid = grid;
}

Cell cell_of(const GridSpec& grid, Point local) {
    const auto column = static_cast<std::int64_t>(std::floor(local.x / grid.cell_size)) + grid.origin_column;
    const auto from_south = static_cast<std::int64_t>(std::floor(local.y / grid.cell_size)) + grid.origin_row;
    return {std::clamp<std::int64_t>(grid.rows - 1 - from_south, 0, grid.rows - 1),
            std::clamp<std::int64_t>(column, 0, grid.columns - 1)};
}

Point gradient(const Raster& terrain, Cell cell) {
    const auto difference = [&](std::int64_t south, std::int64_t east) {
        const auto value = [&](std::int64_t sign) {
            const std::int64_t r = std::clamp<std::int64_t>(cell.row + sign * south, 0, terrain.grid.rows - 1);
            const std::int64_t c = std::clamp<std::int64_t>(cell.column + sign * east, 0, terrain.grid.columns - 1);
            const double z = terrain.at(r, c);
            return std::isnan(z) ? terrain.at(cell.row, cell.column) : z;
        };
        return (value(1) - value(-1)) / (2 * terrain.grid.cell_size);
    };
    return {difference(0, 1), -difference(1, 0)};
}

double map_fraction(const Numerics& numerics, Point slope, Point direction) {
    if (slope_correction(numerics) == SlopeCorrection::none) return 1;
    const double climb = slope.x * direction.x + slope.y * direction.y;
    return 1 / std::sqrt(1 + climb * climb);
}

}  // namespace frana
