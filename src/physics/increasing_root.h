// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace frana {

/// Returns the root of an increasing function with f(0) < 0 <= f(highest), to a relative 1e-14. A guess within a few
/// orders of magnitude is bracketed by factors of four; then regula falsi with the Illinois weights, and bisection if
/// three steps have not halved the bracket. The number of steps is bounded.
template <class Function>
double increasing_root(const Function& f, double highest, double guess) noexcept {
    double high = guess > 0 && guess < highest ? guess : highest, low = 0, f_high = f(high), f_low = 0;
    while (f_high < 0 && high < highest) {
        low = high;
        f_low = f_high;
        high = std::min(4 * high, highest);
        f_high = f(high);
    }
    if (!(f_high > 0)) return high;
    while (low == 0) {
        const double x = 0.25 * high, value = x > 1e-300 ? f(x) : -1;
        if (value < 0) {
            low = x;
            f_low = value;
        } else {
            high = x;
            f_high = value;
        }
    }
    double width = high - low;
    int side = 0;  // which end moved last
    for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
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
