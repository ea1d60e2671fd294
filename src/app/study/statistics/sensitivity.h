// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "app/study/openturns/functions.h"
#include "app/study/statistics/cell_statistics.h"
#include "core/raster.h"

namespace frana::app::study {

/// Least q2 of polynomials from which fractions of the variance are told.
inline constexpr double k_least_q2 = 0.7;
/// Returns the elementary effects of Morris' design, with the interval of their mean from its scatter over the groups.
/// @param output by row: the points, then each key moved
std::vector<KeySensitivity> elementary_effects(const DesignPoints& points, const std::vector<double>& output,
                                               std::size_t groups);

/// Returns the places of members of which none are known: mean ranks, even in (0, 1).
Places rank_places(const DesignPoints& points);

/// Rank correlations of keys with an output, for independent members of equal weight; by key, none where either does
/// not vary.
std::vector<KeySensitivity> rank_correlations(const DesignPoints& points, const std::vector<double>& output);

/// Returns whether two keys of a table correlate more than independent ones do in one of thousands of tables:
/// beyond 4 / sqrt(members).
bool are_correlated(const DesignPoints& points);

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
