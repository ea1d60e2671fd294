// SPDX-License-Identifier: Apache-2.0
#include "simulation/terrain_sample.h"

#include <algorithm>
#include <cmath>

namespace frana {

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
