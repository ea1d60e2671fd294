// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/default_values.h"

namespace frana::structured {

/// Clear water, in which settling velocities are defined (not in the mixture).
struct SettlingFluid {
    double gravity = k_standard_gravity;
    double density = k_fluid_density;   ///< [kg/m3]
    double kinematic_viscosity = 1e-6;  ///< [m2/s]
};

/// Terminal velocity of a grain [m/s]: Stokes up to 0.1 mm; Zanke (1977) above it (paper, equation 73, root restored),
///     U = 10 nu / d [ sqrt(1 + 0.01 (rho_s / rho_f - 1) g d^3 / nu^2) - 1 ]
/// which is 13 % less than Stokes where the two meet. Zero for grains that float.
/// @param diameter d > 0 [m]
inline double settling_velocity(const SettlingFluid& fluid, double grain_density, double diameter) noexcept {
    constexpr double k_stokes_until = 1e-4;
    const double buoyant = (grain_density / fluid.density - 1) * fluid.gravity, nu = fluid.kinematic_viscosity;
    if (!(buoyant > 0)) return 0;
    if (diameter <= k_stokes_until) return buoyant * diameter * diameter / (18 * nu);
    return 10 * nu / diameter * (std::sqrt(1 + 0.01 * buoyant * diameter * diameter * diameter / (nu * nu)) - 1);
}

/// Volume fractions of a column, grain and block sizes: the inputs of the drag.
struct Mixture {
    double solids = 0;             ///< alpha_s
    double coupled = 0;            ///< alpha_c, solids with confined fluid
    double structured = 0;         ///< f_sc
    double confined = 0;           ///< f_fc
    double coupled_density = 0;    ///< rho_c [kg/m3]
    double grain_density = 0;      ///< rho_s [kg/m3]
    double grain_diameter = 1e-3;  ///< d [m]
    double block_size = 1;         ///< d_sc of the structured part: the local depth [m]
};

/// Two-phase drag generalised to structured solids (Pudasaini 2012, Pudasaini & Mergili 2019; paper, equations 31 to 34
/// and 61 to 64, the exponent on the whole bracket):
///     C = f_sc     a_c a_u (rho_c - rho_f) g / [ U_Tc G + S ]^j
///       + (1-f_sc) a_c a_u (rho_s - rho_f) g / [ U_Tu (P F + (1 - P) G) + S ]^j
///     F = gamma / 180 (a_f / a_s)^3 Re,   G = a_f^(M - 1),   Re = d U_T / nu,   S = (P / a_c + (1 - P) / a_u) K
/// with P = 0 in the structured part. The force on solids and confined fluid is C w |w|^(j-1), w = u_u - u_c, the
/// opposite on the free fluid [N/m3]. Zero where either phase is less than a thousandth of the column.
struct Drag {
    SettlingFluid fluid;
    int exponent = 2;               ///< j: 1 linear, 2 quadratic
    double smoothing_velocity = 1;  ///< K [m/s]: that of r.avaflow, for the mixture's flux of equation 34

    /// C [kg m^-3 s^-1 (m/s)^(1-j)].
    [[nodiscard]] double operator()(const Mixture& m) const noexcept {
        constexpr double k_least = 1e-3;
        const double free = 1 - m.coupled;
        if (!(m.coupled > k_least && free > k_least && m.coupled_density > fluid.density)) return 0;
        const double k = smoothing_velocity;
        const double weight = m.coupled * free * fluid.gravity;
        double sum = 0;
        if (m.structured > 0) {
            constexpr double k_largest_block = 1;  // [m] settling laws do not apply to larger ones
            const double size = std::min(m.block_size, k_largest_block);
            const double u = settling_velocity(fluid, m.coupled_density, size);
            sum += m.structured * weight * (m.coupled_density - fluid.density) / power(u * solid_like(m) + k / free);
        }
        if (m.structured < 1) {
            const double u = settling_velocity(fluid, m.grain_density, m.grain_diameter);
            sum += (1 - m.structured) * loose(m, u, u * m.grain_diameter / fluid.kinematic_viscosity, fraction(m), k);
        }
        return sum;
    }

    /// Coefficient of the loose part, for given U_T, Re, P and K.
    [[nodiscard]] double loose(const Mixture& m, double terminal, double reynolds, double p, double k) const noexcept {
        const double free = 1 - m.coupled;
        const double like_fluid = fluid_like(m, reynolds), like_solid = solid_like(m);
        const double smooth = (p / m.coupled + (1 - p) / free) * k;
        return m.coupled * free * (m.grain_density - fluid.density) * fluid.gravity /
               power(terminal * (p * like_fluid + (1 - p) * like_solid) + smooth);
    }
    /// F, after Kozeny and Carman.
    [[nodiscard]] double fluid_like(const Mixture& m, double reynolds) const noexcept {
        constexpr double k_least_solids = 1e-3;
        const double ratio = (1 - m.solids) / std::max(m.solids, k_least_solids);
        return fluid.density / m.grain_density / 180 * ratio * ratio * ratio * reynolds;
    }
    /// P of the loose part, [alpha_s (1 - f_sc) / (alpha_f (1 - f_fc))]^m with the paper's m = 1, at most 1.
    [[nodiscard]] double fraction(const Mixture& m) const noexcept {
        const double open = (1 - m.solids) * (1 - m.confined);
        const double quotient = m.solids * (1 - m.structured) / std::max(open, 1e-12);
        return std::min(1.0, quotient);
    }

  private:
    [[nodiscard]] double power(double bracket) const noexcept { return exponent == 1 ? bracket : bracket * bracket; }
    /// G, after Richardson and Zaki, with their exponent M of grains in turbulent water (paper, equation 32).
    [[nodiscard]] static double solid_like(const Mixture& m) noexcept {
        constexpr double k_exponent = 2.4;
        return std::pow(1 - m.solids, k_exponent - 1);
    }
};

/// Reduction of the relative velocity w by dt of drag alone, exact:  w exp(-lambda dt) for j = 1, w / (1 + lambda |w|
/// dt) for 2.
/// @returns the factor on w
inline double drag_decay(int exponent, double lambda, double speed, double dt) noexcept {
    return exponent == 1 ? std::exp(-lambda * dt) : 1 / (1 + lambda * speed * dt);
}

/// Mass of fluid that accelerates with the solids (paper, equations 35 and 65; Pudasaini 2012):
///     C = (1 + 2 a_c) / (2 a_u)
struct VirtualMass {
    bool acts = true;

    /// m_v = rho_u h_c C [kg/m2], at most twice the lesser of the two masses (the law diverges without free fluid).
    /// @param coupled, free alpha_c, alpha_u [-]
    /// @param coupled_mass, free_mass per unit area [kg/m2]
    [[nodiscard]] double operator()(double coupled, double free, double coupled_mass, double free_mass) const noexcept {
        if (!acts || !(coupled > 0 && free > 0)) return 0;
        const double c = 0.5 * (1 + 2 * coupled) / free;
        return std::clamp(free_mass * coupled / free * c, 0.0, 2 * std::min(coupled_mass, free_mass));
    }
};

/// Force per unit area by the virtual mass on the solids, the opposite on the fluid [N/m2]: the closed form of
///     m_c a_c = m_c a_c0 + f,   m_u a_u = m_u a_u0 - f,   f = m_v (a_u - a_c)
/// @param apart a_u0 - a_c0: difference of the accelerations without it [m/s2]
inline Eigen::Vector2d virtual_mass_force(double virtual_mass, double coupled_mass, double free_mass,
                                          const Eigen::Vector2d& apart) noexcept {
    return virtual_mass * apart / (1 + virtual_mass * (1 / coupled_mass + 1 / free_mass));
}

/// Laws of the interaction of solids and free fluid.
struct CouplingLaws {
    bool buoyancy = true;
    bool drags = true;
    Drag drag;
    VirtualMass virtual_mass;
    double dry = k_dry_depth;  ///< least depth of free fluid that counts as fluid [m]
};

/// Solids and free fluid of one cell, per unit area in map view.
struct CellPhases {
    double solids = 0, confined = 0, free = 0;  ///< h_s, h_fc, h_u [m]
    double coupled_mass = 0;                    ///< m_c [kg/m2]
    double structured = 0;                      ///< f_sc
    double grain_diameter = 1e-3;               ///< d [m]
    double friction = 0;                        ///< greatest shear stress of the bed on the solids [Pa]
    Eigen::Vector2d coupled_velocity{0, 0};     ///< u_c before the step [m/s]
    Eigen::Vector2d free_velocity{0, 0};        ///< u_u after pressure, stress and resistance of the fluid [m/s]
    Eigen::Vector2d push{0, 0};                 ///< acceleration of the solids by all but friction and drag [m/s2]
    Eigen::Vector2d free_push{0, 0};            ///< acceleration of the fluid by all except drag:
                                                ///< pressure, stress, resistance [m/s2]
};

/// Impulse per unit area that the solids gain and the fluid loses over dt by virtual mass and drag [kg/(m s)], if the
/// solids would be at `next` [m/s] without it and answer it with the mass `answering` [kg/m2] (infinite: they do not).
inline Eigen::Vector2d impulse_on(const CouplingLaws& laws, const CellPhases& cell, const Eigen::Vector2d& next,
                                  double answering, double dt) noexcept {
    using Eigen::Vector2d;
    const double fluid_density = laws.drag.fluid.density;
    const double coupled = cell.solids + cell.confined, depth = coupled + cell.free;
    const double m_c = cell.coupled_mass, m_u = fluid_density * cell.free;
    const double grain_density = (m_c - fluid_density * cell.confined) / cell.solids;
    const double alpha_c = coupled / depth, alpha_u = cell.free / depth;

    const double m_v = laws.virtual_mass(alpha_c, alpha_u, m_c, m_u);
    Vector2d impulse = Vector2d::Zero();
    if (m_v > 0) {
        const Vector2d apart = cell.free_push - (next - cell.coupled_velocity) / dt;
        impulse = dt * virtual_mass_force(m_v, answering, m_u, apart);
    }
    if (!laws.drags) return impulse;
    const Vector2d u_c = next + impulse / answering, u_u = cell.free_velocity - impulse / m_u;
    Mixture m;
    m.solids = cell.solids / depth;
    m.coupled = alpha_c;
    m.structured = cell.structured;
    m.confined = cell.confined / (cell.confined + cell.free);
    m.coupled_density = m_c / coupled;
    m.grain_density = grain_density;
    m.grain_diameter = cell.grain_diameter;
    m.block_size = depth;
    const Vector2d w = u_u - u_c;
    // The virtual mass couples the two phases during the drag: their momenta change by m_r w only, and the bare masses
    // carry the fraction that corresponds to a change of w.
    const double bare = m_u / (1 + m_u / answering), reduced = bare + m_v;
    const double lambda = depth * laws.drag(m) / reduced;
    const double lost = bare * (1 - drag_decay(laws.drag.exponent, lambda, std::hypot(w.x(), w.y()), dt));
    return impulse + lost * w;
}

/// Impulse per unit area that the solids gain and the fluid loses over dt by virtual mass and drag [kg/(m s)].
///
/// The virtual mass acts on the accelerations that both phases would have otherwise, including bed friction on the
/// solids and bed resistance on the fluid. The drag is then solved exactly for the relative velocity w, with the
/// reduced mass m_r = m_c m_u / (m_c + m_u) + m_v:  lambda = h C / m_r  (drag_decay).
///
/// Solids that the bed holds answer an impulse only as far as friction has nothing left against it: with the mass
/// m_c J / (J - S) for an impulse J over the friction's reserve S, and with an infinite one below. So the virtual mass
/// has no effect where neither phase accelerates: solids at rest do not disturb a fluid at rest, and a steady stream
/// over them has the speed at which drag and resistance balance its weight.
inline Eigen::Vector2d exchange(const CouplingLaws& laws, const CellPhases& cell, double dt) noexcept {
    using Eigen::Vector2d;
    constexpr int k_rounds = 3;  // each halves what the answering mass is wrong by, or more
    if (!(cell.coupled_mass > 0 && cell.free > laws.dry)) return Vector2d::Zero();
    Vector2d next = cell.coupled_velocity + dt * cell.push;
    const double speed = std::hypot(next.x(), next.y()), loss = dt * cell.friction / cell.coupled_mass;
    if (speed > loss) {
        next *= 1 - loss / speed;
        return impulse_on(laws, cell, next, cell.coupled_mass, dt);
    }
    next = Vector2d::Zero();
    const double reserve = cell.coupled_mass * (loss - speed);
    Vector2d impulse = impulse_on(laws, cell, next, std::numeric_limits<double>::infinity(), dt);
    for (int i = 0; i < k_rounds; ++i) {
        const double size = std::hypot(impulse.x(), impulse.y());
        if (size <= reserve) break;
        impulse = impulse_on(laws, cell, next, cell.coupled_mass * size / (size - reserve), dt);
    }
    return impulse;
}

}  // namespace frana::structured
