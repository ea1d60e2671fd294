// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "study/study_spec.h"

namespace frana::study {

/// Members drawn near others that explain the surveys, with the density from which they were drawn.
struct RefinedPlaces {
    Places places;
    std::vector<double> density;  ///< by member, relative to the prior, which is 1 everywhere in the cube
};

/// Draws places in the unit cube from the density
///
///     q(u) = a + (1 - a) sum_i w_i prod_k t(u_k; u_ik, b_k),    a = 0.2
///
/// t: normal density about a place of the design, cut off at the cube's faces; b_k = s_k n^(-1/(d + 4)) (Scott 1992)
/// from the weighted standard deviation s_k, the effective number of places n and the number of keys d, at least 0.02.
/// The part a is drawn from the prior: every weight prior / q is at most 1 / a (Hesterberg 1995).
/// @param weights by place of the design; their sum is 1
RefinedPlaces refined_places(const Places& design, const std::vector<double>& weights, std::size_t count,
                             std::int64_t seed);

}  // namespace frana::study
