// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace frana {

/// Root of an increasing function with f(low) <= 0 <= f(high), to the last few digits: regula falsi with the
/// Illinois weights, and bisection where that does not halve the bracket in three steps (steep or flat laws).
/// The count is bounded: bisection alone would need about 60 steps.
template <class Function>
double increasing_root(const Function& f, double low, double high) noexcept {
    double f_low = f(low), f_high = f(high);
    if (!(f_low < 0)) return low;
    if (!(f_high > 0)) return high;
    const double fine = 4e-16 * high;
    double width = high - low;
    int side = 0;  // which end moved last
    for (int i = 0; i < 200 && high - low > fine; ++i) {
        double x = (low * f_high - high * f_low) / (f_high - f_low);
        const bool slow = i % 3 == 2 && high - low > 0.5 * width;
        if (i % 3 == 2) width = high - low;
        if (slow || !(x > low && x < high)) x = 0.5 * (low + high);
        if (!(x > low && x < high)) break;
        const double value = f(x);
        if (value == 0) return x;
        if (value < 0) {
            low = x;
            f_low = value;
            if (side < 0) f_high *= 0.5;
            side = -1;
        } else {
            high = x;
            f_high = value;
            if (side > 0) f_low *= 0.5;
            side = 1;
        }
    }
    return 0.5 * (low + high);
}

}  // namespace frana
