// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/raster.h"

namespace frana {

/// High values of a raster. The greatest value is that of a single cell and depends on chance as much as on the flow;
/// the others are exceeded over an area.
struct PeakValues {
    double greatest = k_no_data;  ///< of all cells; NaN if none has a value
    double p999 = k_no_data;      ///< exceeded over a thousandth of the area; NaN if there is no area
    double p99 = k_no_data;       ///< exceeded over a hundredth of it
};

/// Returns the values of the cells that a mask on the same grid marks (neither 0 nor without data) and that have a
/// value; each cell has equal weight. See percentile().
PeakValues high_values(const Raster& raster, const Raster& mask);

/// Returns the value below which a fraction (0 to 1) of some values lies: of the sorted values, counted from 0, the one
/// at index fraction x (count - 1), interpolated linearly. NaN for no values; none of them may be NaN.
double percentile(std::vector<double> values, double fraction);

}  // namespace frana
