// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "models/structured/coupling/settling_velocity.h"

namespace frana::structured {

/// How the drag's exponent M is determined.
enum class RichardsonZaki {
    constant,   ///< M as given
    by_grains,  ///< M from the particle Reynolds number (Richardson & Zaki 1954)
};

/// How the fluid-like fraction P of the drag is determined.
enum class DragMixing {
    quotient,         ///< [alpha_s (1 - f_sc) / (alpha_f (1 - f_fc))]^m, at most 1 (the paper)
    solids_fraction,  ///< alpha_s^m (Pudasaini & Mergili 2019)
};

/// Volume fractions of a column, grain and block sizes: the inputs of the drag.
struct Mixture {
    double solids = 0;             ///< alpha_s
    double coupled = 0;            ///< alpha_c, solids with confined fluid
    double structured = 0;         ///< f_sc
    double confined = 0;           ///< f_fc
    double coupled_density = 0;    ///< rho_c [kg/m3]
    double grain_density = 0;      ///< rho_s [kg/m3]
    double grain_diameter = 1e-3;  ///< d [m]
    double block_size = 1;         ///< of the structured part [m]
    double flux = 0;               ///< |alpha_c u_c + alpha_u u_u| [m/s]
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
    int exponent = 2;              ///< j: 1 linear, 2 quadratic
    double richardson_zaki = 2.4;  ///< M
    RichardsonZaki exponent_of = RichardsonZaki::constant;
    DragMixing mixing = DragMixing::quotient;
    double mixing_exponent = 1;     ///< m of P
    double smoothing_velocity = 0;  ///< K [m/s]; 0: the mixture's flux

    /// C [kg m^-3 s^-1 (m/s)^(1-j)].
    [[nodiscard]] double operator()(const Mixture& m) const noexcept {
        constexpr double k_least = 1e-3;
        const double free = 1 - m.coupled;
        if (!(m.coupled > k_least && free > k_least && m.coupled_density > fluid.density)) return 0;
        const double k = smoothing_velocity > 0 ? smoothing_velocity : m.flux;
        const double weight = m.coupled * free * fluid.gravity;
        double sum = 0;
        if (m.structured > 0) {
            constexpr double k_largest_block = 1;  // [m] settling laws do not apply to larger ones
            const double size = std::min(m.block_size, k_largest_block);
            const double u = settling_velocity(fluid, m.coupled_density, size);
            sum += m.structured * weight * (m.coupled_density - fluid.density) /
                   power(u * solid_like(m, size, u) + k / free);
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
        const double like_fluid = fluid_like(m, reynolds), like_solid = power_of_fluid(m, reynolds);
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
    /// P of the loose part.
    [[nodiscard]] double fraction(const Mixture& m) const noexcept {
        if (mixing == DragMixing::solids_fraction) return std::pow(m.solids, mixing_exponent);
        const double open = (1 - m.solids) * (1 - m.confined);
        const double quotient = m.solids * (1 - m.structured) / std::max(open, 1e-12);
        return std::min(1.0, mixing_exponent == 1 ? quotient : std::pow(quotient, mixing_exponent));
    }

  private:
    [[nodiscard]] double power(double bracket) const noexcept { return exponent == 1 ? bracket : bracket * bracket; }
    [[nodiscard]] double solid_like(const Mixture& m, double size, double terminal) const noexcept {
        return power_of_fluid(m, terminal * size / fluid.kinematic_viscosity);
    }
    /// G, after Richardson and Zaki.
    [[nodiscard]] double power_of_fluid(const Mixture& m, double reynolds) const noexcept {
        return std::pow(1 - m.solids, zaki(reynolds) - 1);
    }
    [[nodiscard]] double zaki(double reynolds) const noexcept {
        if (exponent_of == RichardsonZaki::constant) return richardson_zaki;
        if (reynolds < 0.2) return 4.65;
        if (reynolds < 1) return 4.35 * std::pow(reynolds, -0.03);
        return reynolds < 500 ? 4.45 * std::pow(reynolds, -0.1) : 2.39;
    }
};

/// Reduction of the relative velocity w by dt of drag alone, exact:  w exp(-lambda dt) for j = 1, w / (1 + lambda |w|
/// dt) for 2.
/// @returns the factor on w
inline double drag_decay(int exponent, double lambda, double speed, double dt) noexcept {
    return exponent == 1 ? std::exp(-lambda * dt) : 1 / (1 + lambda * speed * dt);
}

}  // namespace frana::structured
