// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/raster.h"

namespace frana::render {

/// The part of a raster that a window needs, thinned by averaging blocks of cells so that neither side has
/// more than `most_cells` of them (a block with a gap is a gap); one cell more on each side where there is
/// one. Empty (no columns) when window and raster do not meet.
Raster raster_window(const Raster& raster, const Bounds& window, std::int64_t most_cells);

/// The smallest rectangle round all cells that have a value; nothing if none has.
std::optional<Bounds> data_bounds(const Raster& raster);

/// Value between cell centres, straight in both directions; NaN outside and beside gaps.
double interpolated(const Raster& raster, Point map) noexcept;

/// Value of the cell that holds a point; NaN outside.
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
