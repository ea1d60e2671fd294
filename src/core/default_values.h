// SPDX-License-Identifier: Apache-2.0
// Defaults of scene files that laws and models of the engine use as well: each once.
#pragma once

namespace frana {

inline constexpr double k_standard_gravity = 9.81;      ///< [m/s2]
inline constexpr double k_flow_density = 2000;          ///< bulk density [kg/m3]
inline constexpr double k_fluid_density = 1000;         ///< of the structured model's fluid [kg/m3]
inline constexpr double k_air_density = 1.2;            ///< [kg/m3]
inline constexpr double k_dry_depth = 1e-4;             ///< depth of fluid that does not move [m]
inline constexpr double k_minimum_depth = 0.01;         ///< depth that counts as reached in maxima [m]
inline constexpr double k_yield_regularisation = 0.01;  ///< shear rate below which the yield stress is softened [1/s]

/// Courant number: of the default scheme, whose steps are of second order; of everything else.
constexpr double default_courant(bool second_order) {
    return second_order ? 0.8 : 0.5;
}

inline constexpr double k_courant_of_sweeps = 0.9;  ///< along x and y in turn: finite volumes, structured fluid

/// Material of the structured model's solids, each property of which may vary from place to place; for the scene file's
/// keys (params/keys/material_parameters.h) and the model alike.
struct SolidValues {
    double solid_fraction = 0.5;   ///< alpha_s of solids with pore fluid [-]
    double confined_fraction = 1;  ///< f_fc, confined fraction of the pore fluid [-]
    double cohesion = 0;           ///< of the intact material [Pa]
    double friction = 0;           ///< tan(phi) [-]
    double bed_friction = 0;       ///< tan(phi_b) [-]
    double grain_density = 2400;   ///< [kg/m3]
    double grain_diameter = 1e-3;  ///< d [m]
};

}  // namespace frana
