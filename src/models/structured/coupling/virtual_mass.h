// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace frana::structured {

enum class VirtualMassLaw {
    none,
    pudasaini_2012,  ///< C = (1 + 2 a_c) / (2 a_u) (paper, equation 65)
    pudasaini_2019,  ///< C = (N0 (l + a_c^n) - 1) / (a_c / a_u + gamma), N0 = 10, l = 0.12, n = 1
};

/// Mass of fluid that accelerates with the solids (paper, equation 35).
struct VirtualMass {
    VirtualMassLaw law = VirtualMassLaw::pudasaini_2012;

    /// m_v = rho_u h_c C [kg/m2], at most twice the lesser of the two masses (the law diverges without free fluid).
    /// @param coupled, free alpha_c, alpha_u [-]
    /// @param coupled_mass, free_mass per unit area [kg/m2]
    /// @param density_ratio rho_f / rho_s [-]
    [[nodiscard]] double operator()(double coupled, double free, double coupled_mass, double free_mass,
                                    double density_ratio) const noexcept {
        if (law == VirtualMassLaw::none || !(coupled > 0 && free > 0)) return 0;
        const double c = law == VirtualMassLaw::pudasaini_2012
                             ? 0.5 * (1 + 2 * coupled) / free
                             : (10 * (0.12 + coupled) - 1) / (coupled / free + density_ratio);
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

}  // namespace frana::structured
