// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>

#include "core/lanes.h"
#include "physics/bed_state.h"

namespace frana {

/// Divisor of `left` that gives s1 with b s1 + k s1^2 = left: backward Euler of terms linear (b = 1 + dt times the
/// coefficient) and quadratic (k = dt times the coefficient) in the speed.
template <class Number>
[[gnu::always_inline]] inline Number implicit_divisor(Number left, Number b, Number k) {
    using std::sqrt;
    return 0.5 * (b + sqrt(b * b + 4 * k * left));
}

/// Returns the speed after a step of ds/dt = f - l s - q s^2, never below zero. Its exact solution is
///
///     s1 = (s0 (1 - r l dt / 2) + r f dt) / (1 + r dt (l / 2 + q s0)),   r = tanh(w) / w,   w^2 = dt^2 (l^2 / 4 + q f)
///
/// and here r = 1 / sqrt(1 + w^2), with f of at least 0 in w: of second order, the exact terminal speed, no overshoot
/// however long the step and stiff the resistance.
/// @param start s0 [m/s]  @param gain f dt [m/s]  @param linear l dt  @param square q dt [s/m]
template <class Number>
[[gnu::always_inline]] inline Number speed_after_step(Number start, Number gain, Number linear, Number square) {
    using std::max;
    using std::sqrt;
    const Number zero(0.0), half = 0.5 * linear;
    const Number r = 1 / sqrt(1 + half * half + square * max(zero, gain));
    const Number after = (start * (1 - r * half) + r * gain) / (1 + r * (half + square * start));
    return select(after < 0, zero, after);  // what is not finite remains so, and ends the run
}

struct NoExcess {};

/// A law that is no polynomial of the speed, whichever it is: the call is little beside its iterations, and its formula
/// is compiled in no sweep.
struct ExcessLaw {
    /// Backward Euler beside the polynomial parts; empty: none.
    /// @param left speed without its resistance, yield aside [m/s]
    std::function<double(const BedState&, std::size_t node, double left, double dt)> speed_after;
};

/// Returns the speed after dt under all laws of a place, never below zero: friction cannot reverse the motion, and a
/// constant driving force reaches the exact terminal speed. An excess law is replaced by its resistance over the speed
/// in the middle of the step (backward Euler over half of it), which leaves the step of second order.
/// @param start speed before the step, @param driven the same after all driving forces of the step [m/s]
template <class Excess>
double speed_after_friction(const BedState& bed, std::size_t node, const Excess& excess, double start, double driven,
                            double dt) noexcept {
    if (!(bed.thickness > 0)) return 0;
    const double gain = driven - start - dt * bed.yield;
    double linear = bed.linear;
    if constexpr (!std::is_same_v<Excess, NoExcess>) {
        const double half = 0.5 * dt, left = start + 0.5 * gain;
        if (!(left > 0)) return 0;
        const double middle = excess.speed_after(bed, node, left, half);
        if (!(middle > 0)) return 0;
        linear = ((left - middle) / half - bed.square * middle * middle) / middle;
    }
    return std::min(driven, speed_after_step<double>(start, gain, dt * linear, dt * bed.square));
}

}  // namespace frana
