// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "physics/bed_state.h"

namespace frana {

/// A function's value and derivative at a place.
struct ValueAndSlope {
    double value, slope;
};

/// Returns where an increasing function that is 0 at 0 has a value, to a relative 1e-14, or `highest` if that lies
/// beyond. Newton's steps from the guess, of the logarithms as long as the function is off by more than a third: that
/// is exact for powers, so that a guess may be off by orders of magnitude. Where a step leaves what is known to contain
/// the place: the geometric mean. The number of steps is bounded.
/// @param f returns a ValueAndSlope  @param wanted more than 0
template <class Function>
double place_of_value(const Function& f, double wanted, double highest, double guess) noexcept {
    constexpr double k_last_step = 1e-9;  // relative; its square is the error of the next place
    double low = 0, high = highest, x = guess > 0 && guess < highest ? guess : highest;
    for (int i = 0; i < 200; ++i) {
        const ValueAndSlope at = f(x);
        if (at.value == wanted) return x;
        (at.value < wanted ? low : high) = x;
        if (!(low < high)) return high;
        const double ratio = at.value / wanted;
        double next = ratio > 0.75 && ratio < 1.5 ? x + (wanted - at.value) / at.slope
                                                  : x * std::pow(ratio, -at.value / (x * at.slope));
        if (std::abs(next - x) <= k_last_step * x) return next;
        if (next >= high && high == highest) {
            next = highest;
        } else if (!(next > low && next < high)) {
            next = low > 0 ? std::sqrt(low) * std::sqrt(high) : 0.25 * high;
        }
        x = next;
    }
    return x;
}

/// Backward Euler of a law beside the polynomial parts, for place_of_value: s1 + dt (R + linear s1 + square s1^2),
/// which must be the speed left by yield, and its derivative in any unknown of which the speed s1 and the resistance R
/// [m/s2] are functions.
inline ValueAndSlope speed_balance(const ValueAndSlope& s, const ValueAndSlope& resistance, const BedState& bed,
                                   double dt) noexcept {
    return {s.value + dt * (resistance.value + s.value * (bed.linear + s.value * bed.square)),
            s.slope + dt * (resistance.slope + s.slope * (bed.linear + 2 * s.value * bed.square))};
}

}  // namespace frana
