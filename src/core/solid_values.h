// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

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
