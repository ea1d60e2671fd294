// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/lanes.h"

namespace frana {

/// zeta = tau_Y / tau_B, the fraction of the depth that moves as a plug, for a Bingham fluid in steady simple
/// shear:
///
///     zeta^3 - (3 + a) zeta + 2 = 0,   a = 6 mu |v| / (tau_Y h) >= 0
///
/// (from |v| = tau_B h / (6 mu) (2 + zeta)(1 - zeta)^2; the paper's equations 7-8 have misprints). zeta is 1 at rest (a
/// = 0) and tends to 2 / (3 + a) for fast flow.
struct ExactYieldRatio {
    /// Newton's method from a start within 1 % of the root everywhere and much closer at both ends: two steps reach
    /// 1e-9, three the limit of rounding (1e-10 at a = 1e-12, where the root is nearly double).
    template <LaneNumber Number>
    [[nodiscard, gnu::always_inline]] Number operator()(Number a) const noexcept {
        using std::max;
        using std::min;
        using std::sqrt;
        const Number p = 3 + a, inverse = 1 / p, none(0.0), all(1.0);
        // Near a = 0, with zeta = 1 - e: 3 e^2 - e^3 = a (1 - e), so e ~ sqrt(a / 3) - a / 9. For large a one step of
        // zeta = (2 + zeta^3) / p from 2 / p.
        Number zeta =
            select(a < 1, 1 - sqrt(a * (1.0 / 3)) + a * (1.0 / 9), 2 * inverse * (1 + 4 * inverse * inverse * inverse));
        for (int i = 0; i < 3; ++i) {
            const Number slope = 3 * zeta * zeta - p;
            zeta = select(slope > -1e-12, zeta, zeta - (zeta * zeta * zeta - p * zeta + 2) / slope);
        }
        return min(max(zeta, none), all);
    }
};

}  // namespace frana
