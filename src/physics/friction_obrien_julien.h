// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "physics/friction_manning.h"
#include "physics/law.h"

namespace frana {

/// The quadratic rheology of hyperconcentrated flow, as used by FLO-2D:
///
///     R(s) = tau_y / (rho d) + K eta s / (8 rho d^2) + g n^2 s^2 / d^(4/3)      [m/s2]
///
/// tau_y yield stress [Pa], eta Bingham viscosity [Pa s], K laminar resistance (24 for a smooth wide channel,
/// to 50000 on rough ground) [-], n Manning roughness for turbulence and dispersion [s/m^(1/3)], d thickness [m], s
/// speed [m/s]. Range: slurries with 20 to 55 % sediment by volume. Limits: tau_y is a bound at speed zero; all parts
/// are stiff for d -> 0 and applied implicitly. Sources: Julien and Lan 1991, J. Hydraul. Eng. 117, 346; O'Brien,
/// Julien, Fullerton 1993, J. Hydraul. Eng. 119, 244 (friction slope S_f = R / g). The exact wide-channel Newtonian
/// limit, 3 eta s / (rho d^2), is K = 24.
struct OBrienJulienFriction {
    static constexpr const char* word = "obrien-julien";
    struct Values {
        std::optional<double> laminar_resistance;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::laminar_resistance, "material.laminar-resistance",
                                  worded("laminar resistance"), "", {24, 50000}, "K of the viscous part.",
                                  shortest_text(OBrienJulienFriction{}.laminar_resistance) + ", a smooth wide bed")};
    }
    static Law row() {
        return {.sentence = worded("O'Brien-Julien bed resistance"),
                .reads = {"material.yield-stress", "material.viscosity", "material.manning"},
                .resists_alike = {"resistance of the fluid"}};
    }
    static OBrienJulienFriction build(const auto& b) {
        const auto& m = b.material;
        const OBrienJulienFriction law;
        return {b.gravity,
                m.density,
                m.yield_stress,
                m.viscosity,
                m.laminar_resistance.value_or(law.laminar_resistance),
                m.manning.value_or(law.manning)};
    }
    [[nodiscard]] bool yields() const noexcept { return yield_stress > 0; }

    double gravity = k_standard_gravity;  ///< [m/s2]
    double density = k_flow_density;      ///< [kg/m3]
    double yield_stress = 0;              ///< tau_y [Pa]
    double viscosity = 0;                 ///< eta [Pa s]
    double laminar_resistance = 24;       ///< K [-]
    double manning = 0;                   ///< n [s/m^(1/3)]

    void operator()(BedState& bed, std::size_t) const noexcept {
        const double d = bed.thickness;
        bed.yield += yield_stress / (density * d);
        bed.linear += laminar_resistance * viscosity / (8 * density * d * d);
        bed.square += manning_resistance(gravity, manning, d);
    }
};

}  // namespace frana
