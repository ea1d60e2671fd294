// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "core/raster.h"

namespace frana {

/// A raster that has `value` but where a flow comes. From a map of half a thousand cells a side on it is tiled, so that
/// cells that nothing reaches take neither memory nor time.
inline Raster reached_raster(GridSpec grid, double value) {
    constexpr std::int64_t k_largest_plain = 1 << 18;
    if (grid.cell_count() <= k_largest_plain) return Raster(std::move(grid), value);
    Raster raster;
    raster.values = CellValues::tiled(grid.rows, grid.columns, value);
    raster.grid = std::move(grid);
    return raster;
}

}  // namespace frana
