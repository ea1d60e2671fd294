// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "models/structured/solid/elasticity.h"
#include "models/structured/solid/stress.h"

namespace frana::structured {

/// Drucker-Prager strength, matched to Mohr-Coulomb in plane strain (paper, equations 16 and 20):
///     f = sqrt(J2) + a I1 - k <= 0,   a = tan(phi) / sqrt(9 + 12 tan^2 phi),   k = 3 c / sqrt(9 + 12 tan^2 phi)
struct DruckerPrager {
    double slope = 0;     ///< a [-]
    double strength = 0;  ///< k [Pa]

    /// @param friction tan(phi) [-]
    /// @param cohesion c [Pa]
    static DruckerPrager of(double friction, double cohesion) noexcept {
        const double root = 1 / std::sqrt(9 + 12 * friction * friction);
        return {friction * root, 3 * cohesion * root};
    }
    [[nodiscard]] double yield(const Stress& s) const noexcept {
        return std::sqrt(s.j2()) + slope * s.i1() - strength;
    }
};

struct Returned {
    Stress stress;
    bool yielded = false;
};

/// Brings a stress back to the yield surface (paper, Appendix B after Bui et al. 2008, corrected): first tension beyond
/// the apex is cut off, then the deviator is scaled, at unchanged I1.
inline Returned return_to_yield(const DruckerPrager& law, Stress s) noexcept {
    bool yielded = false;
    const double beyond = law.slope * s.i1() - law.strength;
    if (law.slope > 0 && beyond > 0) {
        const double cut = beyond / (3 * law.slope);
        s = {s.xx - cut, s.yy - cut, s.zz - cut, s.xy};
        yielded = true;
    }
    const double allowed = std::max(law.strength - law.slope * s.i1(), 0.0), j2 = s.j2();
    if (j2 > allowed * allowed) {
        const double ratio = allowed / std::sqrt(j2), mean = s.i1() / 3;
        s = {mean + ratio * (s.xx - mean), mean + ratio * (s.yy - mean), mean + ratio * (s.zz - mean), ratio * s.xy};
        yielded = true;
    }
    return {s, yielded};
}

/// Rate of the plastic multiplier for the potential g = sqrt(J2) + 3 I1 sin(psi) (paper, equation 22 corrected), of a
/// stress on the yield surface; 0 where the strain unloads it.
inline double plastic_multiplier(const DruckerPrager& law, const Elasticity& elastic, double sin_dilatancy,
                                 const Stress& s, const VelocityGradient& l) noexcept {
    const double root = std::sqrt(s.j2()), mean = s.i1() / 3, tr = l.divergence();
    const double along = (s.xx - mean) * l.xx + (s.yy - mean) * l.yy + 2 * s.xy * l.shear();
    const double shearing = root > 0 ? elastic.shear / root * along : 0;
    const double rate = (3 * law.slope * elastic.bulk * tr + shearing) /
                        (27 * law.slope * elastic.bulk * sin_dilatancy + elastic.shear);
    return std::max(rate, 0.0);
}

/// Change of stress that a plastic multiplier (rate times dt) takes back.
inline Stress plastic_decrement(const Elasticity& elastic, double sin_dilatancy, const Stress& s,
                                double multiplier) noexcept {
    const double root = std::sqrt(s.j2()), mean = s.i1() / 3;
    const double hydrostatic = multiplier * 9 * elastic.bulk * sin_dilatancy;
    const double deviator = root > 0 ? multiplier * elastic.shear / root : 0;
    return {hydrostatic + deviator * (s.xx - mean), hydrostatic + deviator * (s.yy - mean),
            hydrostatic + deviator * (s.zz - mean), deviator * s.xy};
}

}  // namespace frana::structured
