// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace frana::structured {

/// Rankine's earth pressure coefficients: K_a = (1 - sin phi) / (1 + sin phi), K_p = 1 / K_a (the paper prints K_a for
/// both).
/// @param friction tan(phi) [-]
inline double active_coefficient(double friction) noexcept {
    const double sine = friction / std::sqrt(1 + friction * friction);
    return (1 - sine) / (1 + sine);
}

/// Thrust of a column on its neighbours by Bell's active pressure K_a sigma_v - 2 c sqrt(K_a), with a tension crack
/// where the pressure would be negative (textbook; the paper's equation 43 lacks root, crack and the factor 1/2 of the
/// mean):
///     P = K_a w (h - z)^2 / 2,   z = min(h, 2 c / (w sqrt K_a)),   w = N / h                 [N/m]
/// Without cohesion it is Savage and Hutter's K_a N h / 2; with sufficient cohesion it is zero.
/// @param load effective stress at the base N [Pa]
/// @param depth h [m]
/// @param cohesion present c [Pa]
inline double active_thrust(double coefficient, double load, double depth, double cohesion) noexcept {
    if (!(load > 0 && depth > 0)) return 0;
    const double root = std::sqrt(coefficient) * load;
    if (2 * cohesion >= root) return 0;
    const double pushing = 1 - 2 * cohesion / root;  // fraction of the depth below the crack
    return 0.5 * coefficient * load * depth * pushing * pushing;
}

/// The same with Bell's passive pressure K_p sigma_v + 2 c sqrt(K_p), for compressed material: P = K_p N h / 2 + 2 c
/// sqrt(K_p) h.
/// @param coefficient K_p = 1 / K_a
inline double passive_thrust(double coefficient, double load, double depth, double cohesion) noexcept {
    return (0.5 * coefficient * load + 2 * cohesion * std::sqrt(coefficient)) * depth;
}

/// Thrust of a column if the load that its strength does not bear acts in all directions alike,
///     P = max(0, N / 2 - q) h                                                                [N/m]
/// Without cohesion it is N h / 2, that of a fluid; a column that bears its own weight has none (ours).
/// @param bears uniaxial strength q [Pa]
inline double hydrostatic_thrust(double load, double depth, double bears) noexcept {
    return std::max(0.0, 0.5 * load - bears) * depth;
}

}  // namespace frana::structured
