// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/cell_values.h"
#include "core/grid_spec.h"

namespace frana {

inline constexpr double k_no_data = std::numeric_limits<double>::quiet_NaN();

/// One value per cell of a GridSpec, row by row from the north. In memory "no data" is NaN; in files it is -9999.
/// If the values come from a source, reading one may throw what reading a file throws.
struct Raster {
    GridSpec grid;
    CellValues values;  ///< rows x columns

    Raster() = default;
    explicit Raster(GridSpec spec, double value = 0.0)
        : grid(std::move(spec)), values(grid.rows, grid.columns, value) {}

    [[nodiscard]] std::size_t index(std::int64_t row, std::int64_t column) const noexcept {
        return static_cast<std::size_t>(row * grid.columns + column);
    }
    [[nodiscard]] double at(std::int64_t row, std::int64_t column) const { return values[index(row, column)]; }
    [[nodiscard]] double& at(std::int64_t row, std::int64_t column) { return values[index(row, column)]; }
    [[nodiscard]] bool has_data(std::int64_t row, std::int64_t column) const { return !std::isnan(at(row, column)); }
};

/// The grid of a window of another grid's cells.
inline GridSpec part_of(const GridSpec& grid, const CellWindow& window) {
    GridSpec part = grid;
    part.west = grid.west + static_cast<double>(window.column) * grid.cell_size;
    part.north = grid.north - static_cast<double>(window.row) * grid.cell_size;
    part.columns = window.columns;
    part.rows = window.rows;
    part.origin_column = part.origin_row = 0;
    return part;
}

/// A window of a raster.
inline Raster part_of(const Raster& raster, const CellWindow& window) {
    Raster part(part_of(raster.grid, window));
    for (std::int64_t row = 0; row < window.rows; ++row)
        for (std::int64_t column = 0; column < window.columns; ++column)
            part.at(row, column) = raster.at(row + window.row, column + window.column);
    return part;
}

}  // namespace frana
