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
    [[nodiscard]] double yield(const Stress& s) const noexcept { return std::sqrt(s.j2()) + slope * s.i1() - strength; }
    /// Greatest vertical pressure at which a column with free sides does not yield, k / (1 / sqrt(3) - a) [Pa].
    [[nodiscard]] double uniaxial() const noexcept { return strength / (k_root - slope); }
    /// Least pressure from all sides at which a column under a vertical pressure does not yield [Pa]; 0 up to the
    /// uniaxial strength. In plane strain, where the law is matched, the least is Rankine's active pressure; with
    /// yielding in both directions, as here, the law requires more.
    [[nodiscard]] double active_pressure(double vertical) const noexcept {
        return std::max(0.0, ((k_root - slope) * vertical - strength) / (k_root + 2 * slope));
    }

    static constexpr double k_root = 0.57735026918962576;  // 1 / sqrt(3)
};

struct Returned {
    Stress stress;
    bool yielded = false;
};

/// Returns a stress to the yield surface at constant vertical component, which is given by the weight (plane-stress
/// plasticity with a normal stress that is not zero; Simo and Hughes, Computational Inelasticity, 3.4); the vertical
/// strain of the column is free. Backward Euler for the potential g = sqrt(J2) + 3 I1 sin(psi) (paper, equation 17
/// corrected) with the in-plane stiffness of the elastic trial. With X the in-plane mean minus the vertical stress, R
/// the radius of its Mohr circle and T = k - 3 a szz the strength where all three are equal,
///     f = sqrt(R^2 + X^2 / 3) + 2 a X - T,   R = r R',   X = [r X' - 18 m s T (1 - r)] / [r + m (1 - 36 a s) (1 - r)]
/// m = (K + G / 3) / (3 G), s = sin(psi), ' the trial, r = 1 / (1 + G lambda / sqrt(J2)): one equation f(r) = 0 on (0,
/// 1), whose left end is inside the surface for psi < 5.5 degrees; for larger psi a column compressed from the sides
/// would widen without bound.
inline Returned return_under_load(const DruckerPrager& law, const Elasticity& elastic, double sin_dilatancy,
                                  const Stress& trial) noexcept {
    constexpr double k_rounding = 1e-12, k_solved = 1e-14;
    constexpr int k_most_steps = 60;
    const double mean = 0.5 * trial.plane.trace();
    const Matrix2d unit = Matrix2d::Identity(), deviator = trial.plane - mean * unit;
    const double radius = std::sqrt(0.5 * deviator.squaredNorm());
    const double bears = law.strength - 3 * law.slope * trial.zz, offset = mean - trial.zz;
    if (!(bears > 0)) return {Stress::isotropic(trial.zz), offset != 0 || radius > 0};
    const auto beyond = [&](double x, double r) { return std::sqrt(r * r + x * x / 3) + 2 * law.slope * x - bears; };
    const double outside = beyond(offset, radius);
    if (!(outside > k_rounding * bears)) return {trial, false};

    const double m = (elastic.bulk + elastic.shear / 3) / (3 * elastic.shear);
    const double opening = 18 * m * sin_dilatancy * bears, fall = m * (1 - 36 * law.slope * sin_dilatancy);
    double low = 0, high = 1, f = beyond(-opening / fall, 0);
    double kept = f / (f - outside), x = offset;  // root of the secant
    for (int i = 0; i < k_most_steps; ++i) {
        const double below = kept + fall * (1 - kept), above = kept * offset - opening * (1 - kept);
        x = above / below;
        const double r = kept * radius, root = std::sqrt(r * r + x * x / 3);
        f = root + 2 * law.slope * x - bears;
        if (std::abs(f) <= k_solved * (bears + root)) break;
        (f > 0 ? high : low) = kept;
        const double dx = ((offset + opening) * below - above * (1 - fall)) / (below * below);
        const double slope = (r * radius + x * dx / 3) / root + 2 * law.slope * dx;
        const double next = kept - f / slope;
        kept = next > low && next < high ? next : 0.5 * (low + high);
    }
    return {{(trial.zz + x) * unit + kept * deviator, trial.zz}, true};
}

/// The same where the vertical stress is the material's own and no load is known: in three dimensions the return has a
/// closed form,
///     lambda = f' / (G + 27 a K sin(psi)),   I1 = I1' - 27 K sin(psi) lambda,   s = s' (1 - G lambda / sqrt(J2'))
/// and a stress beyond the apex is returned to it. For psi = 0 it is the paper's Appendix B (after Bui et al. 2008,
/// corrected).
inline Returned return_by_itself(const DruckerPrager& law, const Elasticity& elastic, double sin_dilatancy,
                                 const Stress& s) noexcept {
    constexpr double k_rounding = 1e-12;
    const double i1 = s.i1(), root = std::sqrt(s.j2()), beyond = root + law.slope * i1 - law.strength;
    if (!(beyond > k_rounding * (law.strength + law.slope * std::abs(i1)))) return {s, false};
    const double lambda = beyond / (elastic.shear + 27 * law.slope * elastic.bulk * sin_dilatancy);
    if (law.slope > 0 && root <= elastic.shear * lambda)
        return {Stress::isotropic(law.strength / (3 * law.slope)), true};
    const double kept = root > 0 ? std::max(0.0, 1 - elastic.shear * lambda / root) : 0;
    return {Stress::isotropic(i1 / 3 - 9 * elastic.bulk * sin_dilatancy * lambda) + kept * s.deviator(), true};
}

}  // namespace frana::structured
