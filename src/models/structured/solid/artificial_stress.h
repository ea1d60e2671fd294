// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "models/structured/solid/strain.h"

namespace frana::structured {

/// Repulsion of material in tension, against clumping (Monaghan 2000, Gray et al. 2001; paper, equation 86, with the
/// missing test for tension): along each principal direction of t, -strength times the positive part,
///     R = -strength sum over n of max(t_n, 0) P_n,   P_1 = (t - t_2) / (t_1 - t_2)
/// @param t depth-integrated stress over areal density squared
inline Matrix2d artificial_stress(const Matrix2d& t, double strength) noexcept {
    const double mean = 0.5 * t.trace(), half = 0.5 * (t(0, 0) - t(1, 1));
    const double radius = std::sqrt(half * half + t(0, 1) * t(0, 1));
    const double first = mean + radius, second = mean - radius;
    if (!(first > 0)) return Matrix2d::Zero();
    if (second > 0) return -strength * t;
    return -strength * first / (first - second) * (t - second * Matrix2d::Identity());
}

}  // namespace frana::structured
