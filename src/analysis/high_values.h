// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/raster.h"

namespace frana {

/// How high a raster goes. The greatest value is that of a single cell, which chance decides as much as the
/// flow; the others are those of an area.
struct PeakValues {
    double greatest = k_no_data;  ///< of all cells; NaN where none has a value
    double p999 = k_no_data;      ///< that a thousandth of the area exceeds; NaN where there is no area
    double p99 = k_no_data;       ///< that a hundredth of it exceeds
};

/// The values above are those of the cells that a mask of the same grid marks (neither 0 nor without data)
/// and that have a value; each cell counts with its area, which is the same for all. See percentile().
PeakValues high_values(const Raster& raster, const Raster& mask);

/// The value below which a fraction (0 to 1) of some values lies: with them sorted and counted from 0, the
/// one in place fraction x (count - 1), linear between two places. NaN where there are none; NaN among them
/// is not allowed.
double percentile(std::vector<double> values, double fraction);

}  // namespace frana
