// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace frana::structured {

/// Viscosity against particles that run into each other (Monaghan; paper, equations 83 and 84, minus sign restored):
///     Pi = (-a c phi + b phi^2) / Sigma,   phi = l v_ij.x_ij / (x_ij^2 + 0.01 l^2)   while v_ij.x_ij < 0, else 0
/// with Sigma the mean areal density [kg/m2]. As a pressure over density squared it repels. pair_sums.h evaluates it.
struct ArtificialViscosity {
    double linear = 1;     ///< a [-]
    double quadratic = 1;  ///< b [-]
    double sound = 0;      ///< c; of a pair the mean of both, of loose material sqrt(g h) [m/s]
    double length = 1;     ///< l [m]

    static constexpr double k_softening = 0.01;
};

/// Stress in the plane, [Pa] or anything that goes like it.
struct PlaneTensor {
    double xx = 0, yy = 0, xy = 0;
};

/// Repulsion where material is in tension, against clumping (Monaghan 2000, Gray et al. 2001; paper, equation 86, with
/// the test for tension that it lacks): along each principal direction of t, -strength times what is above zero.
/// @param t depth-integrated stress over areal density squared
inline PlaneTensor artificial_stress(const PlaneTensor& t, double strength) noexcept {
    const double mean = 0.5 * (t.xx + t.yy), half = 0.5 * (t.xx - t.yy);
    const double radius = std::sqrt(half * half + t.xy * t.xy);
    const double first = mean + radius, second = mean - radius;
    if (!(first > 0)) return {};
    if (second > 0) return {-strength * t.xx, -strength * t.yy, -strength * t.xy};
    // Only the first principal stress pulls; its direction (cos, sin) has cos^2 = (1 + half / radius) / 2.
    const double c2 = 0.5 * (1 + half / radius), cs = 0.5 * t.xy / radius;
    return {-strength * first * c2, -strength * first * (1 - c2), -strength * first * cs};
}

}  // namespace frana::structured
