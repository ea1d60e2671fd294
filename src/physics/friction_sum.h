// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "physics/bed_state.h"
#include "physics/place_of_value.h"

namespace frana {

/// Divisor of `left` that gives s1 with b s1 + k s1^2 = left: backward Euler of terms linear (b = 1 + dt times the
/// coefficient) and quadratic (k = dt times the coefficient) in the speed.
template <class Number>
[[gnu::always_inline]] inline Number implicit_divisor(Number left, Number b, Number k) {
    using std::sqrt;
    return 0.5 * (b + sqrt(b * b + 4 * k * left));
}

/// Returns s1 with s1 + dt (linear s1 + square s1^2) = left, for left > 0: the polynomial part of backward Euler.
template <class Number>
[[gnu::always_inline]] inline Number polynomial_speed(Number linear, Number square, Number left, double dt) {
    return left / implicit_divisor<Number>(left, 1 + dt * linear, dt * square);
}

/// Backward Euler of a law beside the polynomial parts, for place_of_value: s1 + dt (R + linear s1 + square s1^2),
/// which must be the speed left by yield, and its derivative in any unknown of which the speed s1 and the resistance R
/// [m/s2] are functions.
inline ValueAndSlope speed_balance(const ValueAndSlope& s, const ValueAndSlope& resistance, const BedState& bed,
                                   double dt) noexcept {
    return {s.value + dt * (resistance.value + s.value * (bed.linear + s.value * bed.square)),
            s.slope + dt * (resistance.slope + s.slope * (bed.linear + 2 * s.value * bed.square))};
}

struct NoExcess {
    [[nodiscard]] double speed_after(const BedState& bed, std::size_t, double left, double dt) const noexcept {
        return polynomial_speed<double>(bed.linear, bed.square, left, dt);
    }
};

/// Returns the speed after dt under all laws of a place, by backward Euler: s1 + dt R(s1) = s0, never below zero.
/// Friction cannot reverse the motion, and a constant driving force reaches the exact terminal speed.
/// @param s0 speed before friction, including the driving forces of this step [m/s]
template <class Excess>
double speed_after_friction(const BedState& bed, std::size_t node, const Excess& excess, double s0,
                            double dt) noexcept {
    const double left = s0 - dt * bed.yield;
    if (!(bed.thickness > 0) || !(left > 0)) return 0;
    return excess.speed_after(bed, node, left, dt);
}

}  // namespace frana
