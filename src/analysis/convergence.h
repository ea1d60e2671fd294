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

/// Behaviour of a value under refinement.
enum class Trend {
    converging,   ///< differences of one sign that shrink
    oscillating,  ///< differences change their sign
    diverging,    ///< differences grow
    settled,      ///< no difference between the two finest
    terrain,      ///< the terrain has more detail on finer cells than the last refinement added: no order is known
    unknown,      ///< too few resolutions
};

/// The scheme's order: values that approach faster do so by chance, which says nothing of their limit.
inline constexpr double k_scheme_order = 2;

/// Convergence of three or more resolutions, for the finest.
struct GridConvergence {
    Trend trend = Trend::settled;
    double observed_order = 0;  ///< NaN unless converging
    double extrapolated = 0;    ///< Richardson; the finest value itself unless converging at an order up to 2
    double error = 0;           ///< estimated |finest - true|, in the value's unit
    double index_percent = 0;   ///< grid convergence index of the finest, percent of its value
};

/// Richardson extrapolation and grid convergence index (Roache 1994) from the three finest of `levels`, given
/// coarsest first with a constant ratio of cell sizes r:
///
///     p = ln(|f3 - f2| / |f2 - f1|) / ln r,   f_exact ~ f1 + (f1 - f2) / (r^p - 1),   f1 the finest
///     GCI = F |f1 - f2| / (r^p - 1),   F = 1.25, p at least 0.5
///
/// F is 3 and p is taken as 1 where the values do not converge (oscillating, diverging) or the observed order is above
/// the scheme's 2, which is then not used to extrapolate: the index is a caution, not an estimate. Throws Error(input)
/// for fewer than three levels.
GridConvergence grid_convergence(const std::vector<Refinement>& levels);

/// The same for cell sizes whose ratios may be less than 2, on terrain with detail of its own. Of `levels`, coarsest
/// first, S is the greater of
///
///     (max - min of all f on cells of up to 2 h) / (2 - 1)   and   (max - min on cells of up to 4 h) / (4 - 1)
///
/// with h the finest cell size: the change of a first-order method between h and cells of size zero. If f changes
/// monotonically from 4 h to h, the second halving changes it less than the first, and `unseen_detail` is at most 1,
/// the order p is observed on 4 h, 2 h and h; with p limited to 0.5 to 1 the error is the greater of |f(2h) - f(h)| /
/// (2^p - 1) and S, times 1.25 if the observed order is within a tenth of the expected 1, else times 3 (Oberkampf and
/// Roy 2010). Otherwise the error is 3 S, times `unseen_detail` if that exceeds 1. Throws Error(input) unless
/// enough_levels().
GridConvergence grid_convergence(const std::vector<Refinement>& levels, double unseen_detail);

/// Whether these cell sizes, coarsest first, suffice for grid_convergence with `unseen_detail`: three of up to 4 h, one
/// of them 2 h.
bool enough_levels(const std::vector<double>& cell_sizes);

/// Detail of the finest terrain beyond a coarser one, relative to the detail added by the last halving of the cells: 2
/// (finest / now - 1), since the curvature of rough ground (root mean square over the flow's ground [1/m]) doubles with
/// every halving. 0 where the curvature does not grow on finer cells, or its radius is over 10 km.
double unseen_detail(double curvature_now, double curvature_finest);

/// Root mean square of a terrain's second differences divided by the cell size squared [1/m], over the cells whose
/// centres lie where `depth` exceeds `threshold`. The rasters cover the same ground, each on its own grid. 0 if there
/// is no such cell.
double ground_curvature(const Raster& terrain, const Raster& depth, double threshold);

/// Error estimate cell by cell: the estimated error of the finest raster [its unit], with one order for the whole
/// field, from the L1 norms of the differences; a cell that a level never reached counts as zero. NaN where no level
/// reached. Rasters coarsest first, each on its own grid over the same ground.
Raster field_uncertainty(const std::vector<Raster>& levels);

/// "converging", ...
const char* describe(Trend trend);

}  // namespace frana
