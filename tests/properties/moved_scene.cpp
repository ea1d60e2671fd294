// SPDX-License-Identifier: Apache-2.0
#include "moved_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "placed_scene.h"

namespace frana::test {
namespace {

// Every point of the scene's outlines.
Scene with_points(Scene scene, const std::function<Point(Point)>& place) {
    for (ReleaseArea& area : scene.release) {
        for (Polygon& polygon : area.outline) {
            for (Point& p : polygon.outer) p = place(p);
            for (Ring& hole : polygon.holes)
                for (Point& p : hole) p = place(p);
        }
    }
    return scene;
}

}  // namespace

Raster mirrored(const Raster& raster) {
    Raster other(raster.grid);
    for (std::int64_t row = 0; row < raster.grid.rows; ++row)
        for (std::int64_t column = 0; column < raster.grid.columns; ++column)
            other.at(row, column) = raster.at(row, raster.grid.columns - 1 - column);
    return other;
}

Scene mirrored(const Scene& scene) {
    const double both = scene.grid.west + scene.grid.east();
    Scene other = with_points(scene, [&](Point p) { return Point{both - p.x, p.y}; });
    other.terrain = mirrored(scene.terrain);
    place_origin_at(other, {scene.grid.columns - scene.grid.origin_column, scene.grid.origin_row});
    return other;
}

Scene moved(const Scene& scene, std::int64_t east, std::int64_t north) {
    const double dx = scene.grid.cell_size * static_cast<double>(east);
    const double dy = scene.grid.cell_size * static_cast<double>(north);
    Scene other = with_points(scene, [&](Point p) { return Point{p.x + dx, p.y + dy}; });
    other.grid.west += dx;
    other.grid.north += dy;
    other.terrain.grid = other.grid;
    return other;
}

Scene widened(const Scene& scene, std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north,
              double drop) {
    Scene other = scene;
    GridSpec& grid = other.grid;
    grid.columns += west + east;
    grid.rows += south + north;
    grid.west -= grid.cell_size * static_cast<double>(west);
    grid.north += grid.cell_size * static_cast<double>(north);
    other.terrain = Raster(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const std::int64_t r = std::clamp<std::int64_t>(row - north, 0, scene.grid.rows - 1);
            const std::int64_t c = std::clamp<std::int64_t>(column - west, 0, scene.grid.columns - 1);
            const auto beyond = static_cast<double>(std::abs(row - north - r) + std::abs(column - west - c));
            other.terrain.at(row, column) = scene.terrain.at(r, c) - drop * beyond;
        }
    }
    place_origin(other);
    return other;
}

Raster narrowed(const Raster& raster, const GridSpec& grid) {
    const auto west = static_cast<std::int64_t>(std::llround((grid.west - raster.grid.west) / grid.cell_size));
    const auto north = static_cast<std::int64_t>(std::llround((raster.grid.north - grid.north) / grid.cell_size));
    Raster other(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column)
            other.at(row, column) = raster.at(row + north, column + west);
    return other;
}

}  // namespace frana::test
