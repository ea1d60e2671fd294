// SPDX-License-Identifier: Apache-2.0
#include "moved_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>

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

// Sets the origin to a corner of cells, or as place_origin where no cell begins there: the stress of solids acts
// through a lattice that begins at the origin. It is the same lattice in a scene that was turned or mirrored if its
// origin is where the original's came to lie.
void place_origin_at(Scene& scene, OriginCell corner) {
    if (corner.column < scene.grid.columns && corner.row < scene.grid.rows)
        put_origin(scene, corner);
    else
        place_origin(scene);
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

Raster quarter_turned(const Raster& raster) {
    GridSpec grid = raster.grid;
    std::swap(grid.columns, grid.rows);
    grid.north = raster.grid.south() + grid.cell_size * static_cast<double>(grid.rows);
    Raster other(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row)
        for (std::int64_t column = 0; column < grid.columns; ++column)
            other.at(row, column) = raster.at(column, raster.grid.columns - 1 - row);
    return other;
}

Scene turned(const Scene& scene, int quarters) {
    Scene other = scene;
    OriginCell corner{scene.grid.origin_column, scene.grid.origin_row};
    for (int i = 0; i < quarters; ++i) {
        const GridSpec old = other.grid;
        // Relative to the south-western corner, metres are exact.
        other = with_points(std::move(other), [&](Point p) { return Point{old.north - p.y, p.x - old.west}; });
        other.grid = GridSpec();
        other.grid.cell_size = old.cell_size;
        other.grid.columns = old.rows;
        other.grid.rows = old.columns;
        other.grid.north = old.cell_size * static_cast<double>(old.columns);
        other.terrain = quarter_turned(other.terrain);
        other.terrain.grid = other.grid;
        corner = {old.rows - corner.row, corner.column};
    }
    place_origin_at(other, corner);
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
