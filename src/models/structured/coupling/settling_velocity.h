// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

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

}  // namespace frana::structured
