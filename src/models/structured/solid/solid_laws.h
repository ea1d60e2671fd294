// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/default_values.h"
#include "models/structured/coupling/basal_pressure.h"
#include "physics/parameters.h"

namespace frana::structured {

using Eigen::Matrix2d;

/// A tensor in the plane (with lists of lists, Eigen's constructor would loop), and a symmetric one.
inline Matrix2d tensor(double xx, double xy, double yx, double yy) noexcept {
    Matrix2d m;
    m << xx, xy, yx, yy;
    return m;
}
inline Matrix2d symmetric(double xx, double yy, double xy) noexcept {
    return tensor(xx, xy, xy, yy);
}

/// Rate of strain e = (L + L^T) / 2 of a velocity gradient in the plane, L_ab = dv_a / dx_b [1/s] (paper, equation 12
/// corrected), and angular velocity, counter-clockwise positive, of (L - L^T) / 2.
inline Matrix2d strain_rate(const Matrix2d& l) noexcept {
    return 0.5 * (l + l.transpose());
}
inline double spin(const Matrix2d& l) noexcept {
    return 0.5 * (l(1, 0) - l(0, 1));
}

/// Matrix of a rotation by `angle` [rad].
inline Matrix2d rotation(double angle) noexcept {
    double sine, cosine;
    if (std::abs(angle) < 0.02) {  // to all digits of a double in this range
        const double a2 = angle * angle;
        sine = angle * (1 - a2 / 6 * (1 - a2 / 20 * (1 - a2 / 42)));
        cosine = 1 - a2 / 2 * (1 - a2 / 12 * (1 - a2 / 30 * (1 - a2 / 56)));
    } else {
        sine = std::sin(angle);
        cosine = std::cos(angle);
    }
    return tensor(cosine, -sine, sine, cosine);
}

/// R s R^T, a symmetric tensor rotated with its material. Its invariants are conserved, unlike with the explicit
/// Jaumann rate (share/doc/structured.md, "Solids with confined fluid").
inline Matrix2d rotated(const Matrix2d& s, const Matrix2d& rotation) noexcept {
    return rotation * s * rotation.transpose();
}

/// Loss of cohesion while the material yields. Strength distributed uniformly over 0 to 2 c_0 makes the loss linear in
/// the accumulated strain D (paper, equation 26):
///     c / c_0 = max(0, 1 - D / (2 eps_c))
/// Confined fluid and structured fraction decrease in proportion: equations 27 and 28 integrate to f = f_0 c / c_0. The
/// strain is distortion, sqrt(2/3 dev e : dev e): closest to what the paper reports of its scenarios.
struct Fragmentation {
    double critical_strain = 0.05;  ///< eps_c [-]

    /// Increment of D of a yielding material by a strain in the plane.
    [[nodiscard]] double increment(const Matrix2d& strain) const noexcept {
        const double tr = strain.trace();
        const Matrix2d dev = strain - tr / 3 * Matrix2d::Identity();  // its vertical component is -tr / 3
        return std::sqrt(2.0 / 3 * (dev.squaredNorm() + tr * tr / 9));
    }
    [[nodiscard]] double cohesion_ratio(double damage) const noexcept {
        return std::max(0.0, 1 - damage / (2 * critical_strain));
    }
};

/// Stress of a column without vertical shear (paper, equation 40), tension positive [Pa].
struct Stress {
    Matrix2d plane = Matrix2d::Zero();
    double zz = 0;

    static Stress isotropic(double pressure) noexcept { return {pressure * Matrix2d::Identity(), pressure}; }

    [[nodiscard]] double xx() const noexcept { return plane(0, 0); }
    [[nodiscard]] double yy() const noexcept { return plane(1, 1); }
    [[nodiscard]] double xy() const noexcept { return plane(0, 1); }

    [[nodiscard]] double i1() const noexcept { return plane.trace() + zz; }
    /// s = sigma - I1 / 3
    [[nodiscard]] Stress deviator() const noexcept {
        const double mean = i1() / 3;
        return {plane - mean * Matrix2d::Identity(), zz - mean};
    }
    /// J2 = s : s / 2 [Pa2].
    [[nodiscard]] double j2() const noexcept {
        const Stress s = deviator();
        return 0.5 * (s.plane.squaredNorm() + s.zz * s.zz);
    }
    friend Stress operator+(const Stress& a, const Stress& b) noexcept { return {a.plane + b.plane, a.zz + b.zz}; }
    friend Stress operator-(const Stress& a, const Stress& b) noexcept { return {a.plane - b.plane, a.zz - b.zz}; }
    friend Stress operator*(double k, const Stress& s) noexcept { return {k * s.plane, k * s.zz}; }
};

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

/// Thrust of a column if the load that its strength does not bear acts in all directions alike,
///     P = max(0, N / 2 - q) h                                                                [N/m]
/// Without cohesion it is N h / 2, that of a fluid; a column that bears its own weight has none (ours).
/// @param bears uniaxial strength q [Pa]
inline double hydrostatic_thrust(double load, double depth, double bears) noexcept {
    return std::max(0.0, 0.5 * load - bears) * depth;
}

/// Laws and parameters of the solids; constant during a run. Lengths in metres, in map view.
struct SolidLaws {
    explicit SolidLaws(double node_spacing) : side(node_spacing) {}

    double side;         ///< of the stress's nodes [m]
    double spacing = 1;  ///< of particles at the start, dp [m]
    double gravity = k_standard_gravity;
    bool steep = true;  ///< gravity and friction over 1 + |grad b|^2
    Elasticity elastic;
    double sin_dilatancy = 0;  ///< sin(psi)
    BasalPressure basal;
    PorePressure pores;     ///< its density and hydrostatic ratio are each column's own
    bool fractures = true;  ///< cohesion can be lost
    Fragmentation fragmentation;
    double damage_length = 1;  ///< R, over which damage is averaged [m]

    double wave_speed = 0;  ///< of pressure waves in the lightest material [m/s]
    double wave_cfl = 0.8;  ///< fraction of the stress's node spacing that waves cross in a substep
};

}  // namespace frana::structured
