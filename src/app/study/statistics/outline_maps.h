// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "app/study/openturns/functions.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/raster.h"

namespace frana::app::study {

// Where a flow ends is a smooth function of the varied keys, whether it reaches a cell is none. So polynomials of the
// keys (Chaos) tell of each cell the signed distance from the outline of what exceeds a threshold, positive inside.

/// Returns the signed distance of a cell from the outline of what exceeds a threshold [cells], positive inside, by
/// member.
std::vector<double> distances_from_outline(const FinishedMembers& members, Quantity quantity, double threshold,
                                           const GridSpec& grid, std::size_t cell);

/// Returns for each key the fraction of the variance of the distance that it explains alone (Chaos::first_order). NaN
/// where all or none of the members exceed the threshold, and where Chaos::q2 is less than k_least_q2.
/// @param points inputs of the members
std::vector<Raster> outline_fractions(const FinishedMembers& members, const DesignPoints& points, Quantity quantity,
                                      double threshold, const GridSpec& grid);

}  // namespace frana::app::study
