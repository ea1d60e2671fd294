// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "core/raster.h"

namespace frana {

/// Rasters of what a flow reaches are tiled on maps of more cells.
inline constexpr std::int64_t k_largest_plain = 1 << 18;

/// A raster that has `value` but where a flow comes: on a large map cells that nothing reaches take neither memory nor
/// time.
inline Raster reached_raster(GridSpec grid, double value) {
    if (grid.cell_count() <= k_largest_plain) return Raster(std::move(grid), value);
    Raster raster;
    raster.values = CellValues::tiled(grid.rows, grid.columns, value);
    raster.grid = std::move(grid);
    return raster;
}

}  // namespace frana
