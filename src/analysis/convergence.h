// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/raster.h"

namespace frana {

/// One value at one resolution.
struct Refinement {
    double cell_size = 0;  ///< [m]
    double value = 0;
};

/// How a value behaved under refinement.
enum class Trend {
    converging,   ///< differences of one sign that shrink
    oscillating,  ///< differences change their sign
    diverging,    ///< differences grow
    settled,      ///< no difference between the two finest
};

/// What three or more resolutions say about the finest.
struct GridConvergence {
    Trend trend = Trend::settled;
    double observed_order = 0;  ///< NaN unless converging
    double extrapolated = 0;    ///< Richardson; the finest value itself unless converging
    double error = 0;           ///< estimated |finest - true|, in the value's unit
    double index_percent = 0;   ///< grid convergence index of the finest, percent of its value
};

/// Richardson extrapolation and grid convergence index (Roache 1994) from the three finest of `levels`, given
/// coarsest first with a constant ratio of cell sizes r:
///
///     p = ln(|f3 - f2| / |f2 - f1|) / ln r,   f_exact ~ f1 + (f1 - f2) / (r^p - 1),   f1 the finest
///     GCI = F |f1 - f2| / (r^p - 1),   F = 1.25, p held within 0.5 to 2
///
/// F is 3 and p is taken as 1 where the values do not converge (oscillating, diverging): the index is then a
/// caution, not an estimate. Throws Error(input) for fewer than three levels.
GridConvergence grid_convergence(const std::vector<Refinement>& levels);

/// The same, cell by cell, for a field: the estimated error of the finest raster [its unit], with one order
/// for the whole field, from the L1 norms of the differences; a cell that a level never reached counts as
/// zero. NaN where no level reached. Rasters coarsest first, each on its own grid over the same ground.
Raster field_uncertainty(const std::vector<Raster>& levels);

/// "converging", ...
const char* describe(Trend trend);

}  // namespace frana
