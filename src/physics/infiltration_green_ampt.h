// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/parameters.h"

namespace frana {

/// x - ln(1 + x), without the cancellation at small x.
inline double above_logarithm(double x) noexcept {
    if (x > 3e-3) return x - std::log1p(x);
    return x * x * (1.0 / 2 - x * (1.0 / 3 - x * (1.0 / 4 - x * (1.0 / 5 - x * (1.0 / 6 - x / 7)))));
}

/// Infiltration of Green and Ampt (1911), under the depth of the water itself:
///
///     dF/dt = K (1 + (psi + h) D / F),   h = w - F
///
/// F depth infiltrated so far [m], K conductivity of the wetted soil [m/s], psi suction at its lower front [m], D what
/// the soil can still take, porosity minus water content [-], h depth of water on the ground [m]. While nothing comes
/// or goes, w is constant, and the rate is that under no water of another soil,
///
///     dF/dt = c (1 + s / F),   c = K (1 - D),   s = D (psi + w) / (1 - D),
///
/// whose closed form F - F_0 - s ln((F + s)/(F_0 + s)) = c t is solved: exact for any step, at F_0 = 0 too, where the
/// rate has no limit. Vertical, in map view. Without water nothing infiltrates; K = 0 is tight ground, D = 0 takes K.
inline double GreenAmpt::operator()(double before, double water, double dt) const noexcept {
    const double c = conductivity * (1 - deficit) * dt, s = deficit * (suction + water + before) / (1 - deficit);
    if (!(c > 0 && water > 0)) return 0;
    if (!(s > 0)) return std::min(c, water);
    const auto excess = [&](double more) {
        return more * before / (before + s) + s * above_logarithm(more / (before + s)) - c;
    };
    if (excess(water) <= 0) return water;
    // Newton from above, where the convex function leads down to its root; the bound is the sum of what gravity
    // and suction would do alone.
    constexpr double k_near = 1e-9;  // of a change, whose square the error is
    double more = std::min(water, c + std::sqrt(before * before + 2 * c * s) - before);
    for (double change = more; change > k_near * more;) {
        change = excess(more) * (before + more + s) / (before + more);
        more -= change;
    }
    return std::clamp(more, 0.0, water);
}

}  // namespace frana
