// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/raster.h"

namespace frana::render {

/// Returns the part of a raster inside a window, reduced by averaging blocks of cells so that neither side has more
/// than `most_cells` of them (a block with a gap is a gap); one cell more on each side if there is one. Empty (no
/// columns) if window and raster do not overlap.
Raster raster_window(const Raster& raster, const Bounds& window, std::int64_t most_cells);

/// Returns the smallest rectangle around all cells with a value; none if there is no value.
std::optional<Bounds> data_bounds(const Raster& raster);

/// Returns the value interpolated bilinearly between cell centres; NaN outside and beside gaps.
double interpolated(const Raster& raster, Point map) noexcept;

/// Returns the value of the cell that contains a point; NaN outside.
inline double cell_value(const Raster& raster, Point map) noexcept {
    const double column = (map.x - raster.grid.west) / raster.grid.cell_size;
    const double row = (raster.grid.north - map.y) / raster.grid.cell_size;
    if (!(column >= 0 && row >= 0 && column < static_cast<double>(raster.grid.columns) &&
          row < static_cast<double>(raster.grid.rows))) {
        return k_no_data;
    }
    return raster.at(static_cast<std::int64_t>(row), static_cast<std::int64_t>(column));
}

}  // namespace frana::render
