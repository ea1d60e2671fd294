// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"
#include "physics/friction_sum.h"
#include "physics/friction_turbulence.h"
#include "physics/parameters.h"

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
/// turbulent part is infinitely stiff, which the update below bears; at d = 0 the result is rest.
template <class Number>
[[gnu::always_inline]] inline Number VoellmyFriction::speed_after(std::type_identity_t<Number> start,
                                                                  std::type_identity_t<Number> driven, double dt,
                                                                  std::type_identity_t<Number> normal_gravity,
                                                                  double gravity,
                                                                  std::type_identity_t<Number> thickness) const {
    const Number gain = driven - start - dt * (friction_coefficient * normal_gravity);
    const Number after = speed_after_step<Number>(
        start, gain, 0.0, turbulent_resistance<Number>(dt * gravity, inverse_turbulence, thickness));
    return select(thickness > 0, after, Number(0.0));
}

}  // namespace frana
