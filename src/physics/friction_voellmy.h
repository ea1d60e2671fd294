// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace frana {

/// Voellmy bed friction (paper, equation 2), as a deceleration of the speed along the bed:
///
///     R(s) = g_n tan(phi) + p_A tan(phi) / (rho d) + g s^2 / (xi d)     [m/s2]
///
/// g_n  gravity normal to the bed [m/s2], d thickness normal to the bed [m], s speed along the bed [m/s],
/// phi friction angle, xi turbulence coefficient [m/s2] (infinite: off), p_A surface pressure, gauge [Pa].
///
/// Limits: at s = 0 the first two parts are a bound, not a force: what drives less than the bound stays at
/// rest. At d -> 0 the turbulent part is infinitely stiff, so the update below is implicit; at d = 0 the
/// result is rest.
struct VoellmyFriction {
    double friction_coefficient = 0;   ///< tan(phi) [-]
    double inverse_turbulence = 0;     ///< 1 / xi [s2/m]
    double pressure_over_density = 0;  ///< p_A / rho [m2/s2]

    [[nodiscard]] bool active() const noexcept { return friction_coefficient > 0 || inverse_turbulence > 0; }

    /// Speed after dt, by backward Euler: s1 + dt R(s1) = s0, never below zero. A constant drive then reaches
    /// the exact terminal speed, and friction cannot turn the motion round.
    /// @param s0 speed before friction, with the drive of this step already added [m/s]
    [[nodiscard]] double speed_after(double s0, double dt, double normal_gravity, double gravity,
                                     double thickness) const noexcept {
        if (!(thickness > 0)) return 0;
        const double bound = friction_coefficient * (normal_gravity + pressure_over_density / thickness);
        const double left = s0 - dt * bound;
        if (left <= 0) return 0;
        const double k = dt * gravity * inverse_turbulence / thickness;
        return 2 * left / (1 + std::sqrt(1 + 4 * k * left));
    }
};

}  // namespace frana
