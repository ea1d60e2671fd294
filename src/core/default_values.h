// SPDX-License-Identifier: Apache-2.0
// Defaults of scene files that laws and models of the engine use as well: each once.
#pragma once

namespace frana {

inline constexpr double k_standard_gravity = 9.81;      ///< [m/s2]
inline constexpr double k_flow_density = 2000;          ///< bulk density [kg/m3]
inline constexpr double k_fluid_density = 1000;         ///< of the structured model's fluid [kg/m3]
inline constexpr double k_dry_depth = 1e-4;             ///< depth of fluid that does not move [m]
inline constexpr double k_minimum_depth = 0.01;         ///< depth that counts as reached in maxima [m]
inline constexpr double k_yield_regularisation = 0.01;  ///< shear rate below which the yield stress is softened [1/s]

/// Courant number: of the default scheme, whose steps are of second order; of everything else.
constexpr double default_courant(bool second_order) {
    return second_order ? 0.8 : 0.5;
}

}  // namespace frana
