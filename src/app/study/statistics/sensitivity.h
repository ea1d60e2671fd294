// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/study/openturns/functions.h"

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

}  // namespace frana::app::study
