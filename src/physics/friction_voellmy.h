// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "core/lanes.h"
#include "physics/friction_sum.h"
#include "physics/friction_turbulence.h"

namespace frana {

/// Voellmy bed friction (paper, equation 2), as a deceleration of the speed along the bed, with uniform parameters and
/// no other term (friction_coulomb.h, friction_turbulence.h):
///
///     R(s) = g_n tan(phi) + g s^2 / (xi d)     [m/s2]
///
/// g_n  gravity normal to the bed [m/s2], d thickness normal to the bed [m], s speed along the bed [m/s],
/// phi friction angle, xi turbulence coefficient [m/s2] (infinite: off).
///
/// Limits: at s = 0 the first part is a bound, not a force: material driven by less stays at rest. At d -> 0 the
/// turbulent part is infinitely stiff, so the update below is implicit; at d = 0 the result is rest.
struct VoellmyFriction {
    double friction_coefficient = 0;  ///< tan(phi) [-]
    double inverse_turbulence = 0;    ///< 1 / xi [s2/m]

    [[nodiscard]] bool active() const noexcept { return friction_coefficient > 0 || inverse_turbulence > 0; }

    /// Returns the speed after dt, by backward Euler: s1 + dt R(s1) = s0, never below zero. A constant driving force
    /// then reaches the exact terminal speed, and friction cannot reverse the motion.
    /// @param s0 speed before friction, including the driving forces of this step [m/s]
    template <class Number = double>
    [[nodiscard, gnu::always_inline]] Number speed_after(std::type_identity_t<Number> s0, double dt,
                                                         std::type_identity_t<Number> normal_gravity, double gravity,
                                                         std::type_identity_t<Number> thickness) const {
        const Number left = s0 - dt * (friction_coefficient * normal_gravity);
        const Number after =
            left / implicit_divisor<Number>(left, 1.0,
                                            turbulent_resistance<Number>(dt * gravity, inverse_turbulence, thickness));
        return select((thickness > 0) & (left > 0), after, Number(0.0));
    }
};

}  // namespace frana
