// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/raster.h"

namespace frana {

/// A raster of one row.
inline Raster row_of(std::vector<double> values, double cell_size = 10) {
    GridSpec grid;
    grid.cell_size = cell_size;
    grid.columns = static_cast<std::int64_t>(values.size());
    grid.rows = 1;
    Raster raster(grid);
    raster.values = std::move(values);
    return raster;
}

}  // namespace frana
