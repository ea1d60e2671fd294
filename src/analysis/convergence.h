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
    diverging,    ///< differences grow, or shrink by less than a tenth
    settled,      ///< no difference between the two finest
    terrain,      ///< the terrain has more detail on finer cells than the last refinement added: no order is known
    unknown,      ///< too few resolutions
};

/// The scheme's order: values that approach faster do so by chance, which says nothing of their limit.
inline constexpr double k_scheme_order = 2;

/// What several resolutions say of a value on the finest.
struct GridConvergence {
    Trend trend = Trend::settled;
    double observed_order = 0;  ///< NaN unless converging, and at an order up to the scheme's
    double extrapolated = 0;    ///< Richardson (1911), with an order of at least 0.5; the finest value without an order
    double error = 0;           ///< estimated |finest - limit|, in the value's unit; infinite where it diverges
    double index_percent = 0;   ///< the same, percent of the finest value
};

/// Estimates the errors of a run's values together, each given on the same cell sizes, coarsest first, of which one is
/// twice the finest h. Of each value f, S is the greater of
///
///     (max - min of all f on cells of up to 2 h) / (2 - 1)   and   (max - min on cells of up to 4 h) / (4 - 1)
///
/// the change of a first-order method between h and cells of size zero; s = S / |f|. One such difference can be small
/// by chance, so that it is drawn towards those of the other values: with m the median of all s, and s at least a tenth
/// of it,
///
///     error = 1.25 |f| sqrt(s m max(1, unseen_detail))
///
/// 1.25 is the safety factor of the grid convergence index (Roache 1994); the mean is ours (share/doc/accuracy.md). The
/// order p = log2(|f(2h) - f(4h)| / |f(h) - f(2h)|) is observed if f changes monotonically from 4 h to h, the second
/// halving changes it at most 0.9 times as much as the first, and `unseen_detail` is at most 1. Throws Error(input)
/// without three of up to 4 h, one of them 2 h.
std::vector<GridConvergence> grid_convergence(const std::vector<std::vector<Refinement>>& values, double unseen_detail);

/// Whether an accuracy may be claimed from these cell sizes, coarsest first: 4 h and 2 h are among them, from which a
/// trend can be told.
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
