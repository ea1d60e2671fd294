// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "models/structured/solid/stress.h"

namespace frana::structured {

/// Isotropic linear elasticity (paper, equations 10 and 14):  dsigma/dt = 2 G dev(e) + K tr(e) delta.
struct Elasticity {
    double bulk = 0;   ///< K [Pa]
    double shear = 0;  ///< G [Pa]

    /// G = 3 K E / (9 K - E); wants 0 < E < 9 K, which is Poisson's ratio under 1/2 and over -1.
    static Elasticity from_young_and_bulk(double young, double bulk) {
        return {bulk, 3 * bulk * young / (9 * bulk - young)};
    }
    /// Speed of pressure waves in a wide sheet, sqrt((K + 4 G / 3) / rho) [m/s].
    [[nodiscard]] double wave_speed(double density) const noexcept {
        return std::sqrt((bulk + 4 * shear / 3) / density);
    }

    /// Change of stress over dt with no vertical strain (plane strain), 12 of the paper corrected.
    [[nodiscard]] Stress increment(const VelocityGradient& l, double dt) const noexcept {
        const double tr = l.divergence(), mean = bulk * tr, third = tr / 3;
        return {dt * (mean + 2 * shear * (l.xx - third)), dt * (mean + 2 * shear * (l.yy - third)),
                dt * (mean - 2 * shear * third), dt * 2 * shear * l.shear()};
    }
};

}  // namespace frana::structured
