// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "physics/bed_state.h"
#include "physics/law.h"

namespace frana {

/// Cohesion (adhesion) to the bed, independent of the normal stress:
///
///     R = c / (rho d)      [m/s2]
///
/// c cohesion [Pa], rho density [kg/m3], d thickness [m]. Range: c >= 0. Limits: all of it is yield; for d -> 0 it
/// stops all material, so that flow thinner than c / (rho g sin(theta)) stays on the slope. Source: Mohr-Coulomb
/// strength; with Voellmy's friction e.g. Christen, Kowalski, Bartelt 2010, Cold Reg. Sci. Technol. 63, 1.
struct CohesiveFriction {
    static constexpr const char* word = "cohesion";
    struct Values {
        std::optional<double> cohesion;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::cohesion, "material.cohesion", worded("cohesion"), "Pa", {0, 1e6},
                                  "Cohesion to the bed.")};
    }
    static Law row() { return {.sentence = worded("cohesion at the bed")}; }
    static CohesiveFriction build(auto& b) { return {b.material.density, b.cohesion()}; }
    [[nodiscard]] static bool yields() noexcept { return true; }

    double density = k_flow_density;  ///< [kg/m3]
    NodeValue cohesion;               ///< c [Pa]

    void operator()(BedState& bed, std::size_t node) const noexcept {
        bed.yield += cohesion.at(node) / (density * bed.thickness);
    }
};

}  // namespace frana
