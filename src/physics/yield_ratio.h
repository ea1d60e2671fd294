// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace frana {

/// zeta = tau_Y / tau_B, the share of the depth that moves as a plug, for a Bingham fluid in steady simple
/// shear:
///
///     zeta^3 - (3 + a) zeta + 2 = 0,   a = 6 mu |v| / (tau_Y h) >= 0
///
/// (from |v| = tau_B h / (6 mu) (2 + zeta)(1 - zeta)^2; the paper's equations 7-8 carry misprints). zeta is 1
/// at rest (a = 0) and goes to 2 / (3 + a) for fast flow.
struct ExactYieldRatio {
    /// Newton on the monotone branch, from the large-a estimate: 2 / (3 + a) lies below the root and the
    /// cubic is convex and falling there, so every iterate rises to the root and there is no cancellation for
    /// large a. At a -> 0 the root is double and the error halves a step; a small enough for that is caught
    /// by the square root.
    [[nodiscard]] double operator()(double a) const noexcept {
        const double p = 3 + a;
        // Near a = 0, with zeta = 1 - e: 3 e^2 - e^3 = a (1 - e), so e ~ sqrt(a / 3).
        double zeta = a < 1 ? 1 - std::sqrt(a / 3) : 2 / p;
        for (int i = 0; i < 6; ++i) {
            const double slope = 3 * zeta * zeta - p;
            if (slope > -1e-12) break;
            zeta -= (zeta * zeta * zeta - p * zeta + 2) / slope;
        }
        return zeta < 0 ? 0 : zeta > 1 ? 1 : zeta;
    }
};

/// The paper's quadratic (9), 48 zeta^2 - (114 + 32 a) zeta + 65 = 0: the smaller root. Off by up to 0.043.
struct QuadraticYieldRatio {
    [[nodiscard]] double operator()(double a) const noexcept {
        const double b = 57 + 16 * a;
        return 65 / (b + std::sqrt(b * b - 48 * 65));
    }
};

}  // namespace frana
