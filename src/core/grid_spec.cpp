// SPDX-License-Identifier: Apache-2.0
#include "core/grid_spec.h"

#include <cmath>

namespace frana {

bool GridSpec::same_cells(const GridSpec& other) const noexcept {
    const double tolerance = 1e-6 * cell_size;
    return columns == other.columns && rows == other.rows && std::abs(cell_size - other.cell_size) <= tolerance &&
           std::abs(west - other.west) <= tolerance && std::abs(north - other.north) <= tolerance;
}

}  // namespace frana
