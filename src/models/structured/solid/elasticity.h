// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "models/structured/solid/stress.h"

namespace frana::structured {

/// Isotropic linear elasticity (paper, equations 10 and 14):  dsigma/dt = 2 G dev(e) + K tr(e) delta.
struct Elasticity {
    double bulk = 0;   ///< K [Pa]
    double shear = 0;  ///< G [Pa]

    /// G = 3 K E / (9 K - E); requires 0 < E < 9 K, that is, Poisson's ratio between -1 and 1/2.
    static Elasticity from_young_and_bulk(double young, double bulk) {
        return {bulk, 3 * bulk * young / (9 * bulk - young)};
    }
    /// Speed of pressure waves in a wide sheet, sqrt((K + 4 G / 3) / rho) [m/s].
    [[nodiscard]] double wave_speed(double density) const noexcept {
        return std::sqrt((bulk + 4 * shear / 3) / density);
    }

    /// Change of stress by a strain in the plane, with no vertical strain (plane strain).
    [[nodiscard]] Stress increment(const Matrix2d& strain) const noexcept {
        const double tr = strain.trace();
        const Matrix2d unit = Matrix2d::Identity();
        return {bulk * tr * unit + 2 * shear * (strain - tr / 3 * unit), (bulk - 2 * shear / 3) * tr};
    }
};

}  // namespace frana::structured
