// SPDX-License-Identifier: Apache-2.0
#include "core/grid_spec.h"

#include <cmath>

namespace frana {

bool GridSpec::same_cells(const GridSpec& other) const noexcept {
    const double tolerance = 1e-6 * cell_size;
    return columns == other.columns && rows == other.rows && std::abs(cell_size - other.cell_size) <= tolerance &&
           std::abs(west - other.west) <= tolerance && std::abs(north - other.north) <= tolerance;
}

bool GridSpec::covers(const GridSpec& other) const noexcept {
    const double column = (other.west - west) / cell_size, row = (north - other.north) / cell_size;
    const double first_column = std::round(column), first_row = std::round(row);
    return std::abs(cell_size - other.cell_size) <= 1e-6 * cell_size && std::abs(column - first_column) <= 1e-6 &&
           std::abs(row - first_row) <= 1e-6 && first_column >= 0 && first_row >= 0 &&
           first_column + static_cast<double>(other.columns) <= static_cast<double>(columns) &&
           first_row + static_cast<double>(other.rows) <= static_cast<double>(rows);
}

}  // namespace frana
