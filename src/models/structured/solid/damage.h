// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "models/structured/solid/strain.h"

namespace frana::structured {

/// The strain by which yielding material loses its cohesion.
enum class DamageMeasure {
    volumetric,  ///< opening, max(0, tr e) (paper, equation 26): no loss in pure shear
    equivalent,  ///< distortion, sqrt(2/3 dev e : dev e); closest to what the paper reports of its scenarios
};

/// Loss of cohesion while the material yields. Strength distributed uniformly over 0 to 2 c_0 makes the loss linear in
/// the accumulated strain D (paper, equation 26):
///     c / c_0 = max(0, 1 - D / (2 eps_c))
/// Confined fluid and structured fraction decrease in proportion: equations 27 and 28 integrate to f = f_0 c / c_0.
struct Fragmentation {
    double critical_strain = 0.05;  ///< eps_c [-]
    DamageMeasure measure = DamageMeasure::equivalent;

    /// Increment of D of a yielding material by a strain in the plane.
    [[nodiscard]] double increment(const Matrix2d& strain) const noexcept {
        const double tr = strain.trace();
        if (measure == DamageMeasure::volumetric) return std::max(0.0, tr);
        const Matrix2d dev = strain - tr / 3 * Matrix2d::Identity();  // its vertical component is -tr / 3
        return std::sqrt(2.0 / 3 * (dev.squaredNorm() + tr * tr / 9));
    }
    [[nodiscard]] double cohesion_ratio(double damage) const noexcept {
        return std::max(0.0, 1 - damage / (2 * critical_strain));
    }
};

}  // namespace frana::structured
