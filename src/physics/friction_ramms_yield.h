// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "physics/bed_state.h"
#include "physics/law.h"

namespace frana {

/// The yield term of RAMMS, cohesion that increases with the normal stress N = rho g_n d up to (1 - mu) N_0:
///
///     R = (1 - mu) N_0 (1 - exp(-N / N_0)) / (rho d)      [m/s2]
///
/// mu friction coefficient of the Coulomb part used with it [-], N_0 yield stress of the flowing material [Pa], rho
/// density [kg/m3], d thickness [m]. Range: 0 <= mu <= 1, N_0 > 0 (0 to 2000 Pa for snow). Limits: all of it is yield;
/// for d -> 0 it tends to (1 - mu) g_n, which with mu g_n is friction of 45 degrees; no support, no yield. Source:
/// Bartelt, Valero, Feistl, Christen, Buhler, Buser 2015, J. Glaciol. 61, 837, with the RAMMS form S = mu N + rho g u^2
/// / xi + (1 - mu) N_0 - (1 - mu) N_0 exp(-N / N_0).
struct RammsYield {
    static constexpr const char* word = "ramms-yield";
    struct Values {
        std::optional<double> ramms_yield_stress;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::ramms_yield_stress, "material.ramms-yield-stress", "", "Pa", {0, 1e5, true},
                                  "N_0 of RAMMS's yield term.")};
    }
    static Law row() {
        return {.sentence = worded("RAMMS yield term"),
                .reads = {"material.friction-angle", "material.friction-coefficient"},
                .greatest_friction = 1};
    }
    static RammsYield build(auto& b) {
        return {b.material.density, b.material.ramms_yield_stress.value(), b.friction_coefficient()};
    }
    [[nodiscard]] static bool yields() noexcept { return true; }

    double density = k_flow_density;  ///< [kg/m3]
    double yield_stress = 0;          ///< N_0 [Pa]
    NodeValue friction_coefficient;   ///< mu [-]

    void operator()(BedState& bed, std::size_t node) const noexcept {
        const double normal = density * bed.normal_gravity * bed.thickness;
        const double fraction = 1 - friction_coefficient.at(node);
        bed.yield -= (fraction > 0 ? fraction : 0) * yield_stress * std::expm1(-normal / yield_stress) /
                     (density * bed.thickness);
    }
};

}  // namespace frana
