// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "physics/bed_state.h"

namespace frana {

/// What a speed `left` is to be divided by for s1 with b s1 + k s1^2 = left: backward Euler of what is linear (b = 1 +
/// dt times it) and what is quadratic in the speed (k = dt times it).
inline double implicit_divisor(double left, double b, double k) noexcept {
    return 0.5 * (b + std::sqrt(b * b + 4 * k * left));
}

/// s1 with s1 + dt (linear s1 + square s1^2) = left, for left > 0: the polynomial part of backward Euler.
inline double polynomial_speed(const BedState& bed, double left, double dt) noexcept {
    return left / implicit_divisor(left, 1 + dt * bed.linear, dt * bed.square);
}

/// No law beyond the polynomial ones.
struct NoExcess {
    [[nodiscard]] double speed_after(const BedState& bed, std::size_t, double left, double dt) const noexcept {
        return polynomial_speed(bed, left, dt);
    }
};

/// Speed after dt under all laws of a place, by backward Euler: s1 + dt R(s1) = s0, never below zero.
/// Friction cannot turn the motion round, and a constant drive reaches the exact terminal speed.
/// @param s0 speed before friction, with the drive of this step already added [m/s]
template <class Excess>
double speed_after_friction(const BedState& bed, std::size_t node, const Excess& excess, double s0,
                            double dt) noexcept {
    const double left = s0 - dt * bed.yield;
    if (!(bed.thickness > 0) || !(left > 0)) return 0;
    return excess.speed_after(bed, node, left, dt);
}

}  // namespace frana
