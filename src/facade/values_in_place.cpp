// SPDX-License-Identifier: Apache-2.0
#include "facade/values_in_place.h"

#include <algorithm>

namespace frana::facade {

GridSpec spec_of(const Grid& grid) {
    GridSpec spec;
    spec.west = grid.west;
    spec.north = grid.north;
    spec.cell_size = grid.cell_size;
    spec.columns = grid.columns;
    spec.rows = grid.rows;
    return spec;
}

frana::Raster raster_in_place(const GridSpec& grid, const Values& values, const Change& change) {
    frana::Raster raster;
    raster.grid = grid;
    raster.values = CellValues::tiled(grid.rows, grid.columns, k_no_data,
                                      [values, change, columns = grid.columns](const CellWindow& window, double* to) {
                                          double* next = to;
                                          for (std::int64_t row = window.row; row < window.row + window.rows; ++row)
                                              next = std::copy_n(values.cells.data() + row * columns + window.column,
                                                                 window.columns, next);
                                          if (change) change(window, to);
                                      });
    return raster;
}

}  // namespace frana::facade
