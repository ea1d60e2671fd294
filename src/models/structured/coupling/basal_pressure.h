// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/default_values.h"

namespace frana::structured {

/// Load of a column on the bed, per unit area in map view.
struct Column {
    double solids = 0;      ///< h_s [m]
    double confined = 0;    ///< h_fc [m]
    double structured = 0;  ///< f_sc, fraction of the solids that is structured [-]
    double submerged = 0;   ///< fraction of the loose solids' pores that free fluid fills [-]
};

/// Load of solids and confined fluid on the bed, as effective stress (after the paper's equations 37 to 39; its 58 is
/// illegible):
///     N = g [ (1 - f_sc) h_s (rho_s - S rho_f) + f_sc h_s (rho_s - B rho_f) + (1 - B) h_fc rho_f ] >= 0
/// Loose solids have their buoyant weight (Pudasaini 2012); structured solids and their confined fluid have their full
/// weight unless a fraction B of the pore pressure reaches the bed. S is our addition: buoyancy acts on loose solids
/// only in proportion to the free fluid in their pores, so that dry rubble keeps its weight.
struct BasalPressure {
    double gravity = k_standard_gravity;
    double fluid_density = 0;  ///< rho_f; 0 in a scene without any fluid [kg/m3]
    double propagation = 0;    ///< B [-]

    /// N [Pa].
    [[nodiscard]] double operator()(const Column& c, double grain_density) const noexcept {
        const double loose = (1 - c.structured) * c.solids * (grain_density - c.submerged * fluid_density);
        const double whole = c.structured * c.solids * (grain_density - propagation * fluid_density);
        const double pores = (1 - propagation) * c.confined * fluid_density;
        return std::max(0.0, gravity * (loose + whole + pores));
    }
};

}  // namespace frana::structured
