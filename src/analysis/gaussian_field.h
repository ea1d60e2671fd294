// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/cell_values.h"
#include "core/grid_spec.h"

namespace frana {

/// A stationary normal random field with mean 0 on the cells of a map:
///
///     Z(x) = sd sum_i n_i g(x - x_i) / sqrt(sum_i g(x - x_i)^2),   g(d) = exp(-d^2 / (2 s^2)),   s = range / sqrt(12)
///
/// a moving average (Journel & Huijbregts 1978) of independent normal deviates n_i on a lattice of s / 2: each n_i
/// follows from the seed and the place alone, so that the field of a part of the map is a part of the map's field, bit
/// by bit, and that on other cells the same field at their centres. Its correlation over a distance d is exp(-3 d^2 /
/// range^2): 0.05 at the range, as geostatistics defines the practical range of this model. A range below 0.7 cells is
/// one of 0.7 cells: cells are independent of each other.
struct GaussianField {
    double standard_deviation = 0;  ///< [m]
    double range = 1;               ///< [m]
    std::int64_t seed = 0;
};

/// Adds the field to the values of a window of a grid, row by row; NaN stays.
void add_field(const GaussianField& field, const GridSpec& grid, const CellWindow& window, double* values);

}  // namespace frana
