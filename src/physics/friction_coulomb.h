// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/bed_state.h"
#include "physics/law.h"
#include "physics/pore_pressure.h"

namespace frana {

/// Coulomb friction with pore pressure and surface pressure:
///
///     R = tan(phi) ( (1 - r) g_n + p_A / (rho d) )      [m/s2]
///
/// phi friction angle of the bed, r pore pressure over total normal stress (pore_pressure.h) [-], p_A gauge
/// pressure on the free surface [Pa]. Range: tan(phi) 0 to 2, r 0 to 1. Limits: all of it is yield; at speed zero it
/// holds material driven by less; without support (g_n = 0) only the surface pressure acts; for d -> 0 the surface
/// pressure holds all material. Sources: Savage and Hutter 1989 (friction); Hungr 1995, Can. Geotech. J. 32, 610 (r);
/// p_A: Fois, de Falco, Formaggia 2024, equation 2.
struct CoulombFriction {
    static constexpr const char* word = "coulomb";
    struct Values : PoreValues {
        std::optional<double> friction_angle, friction_coefficient;
        double surface_pressure = 0;

        /// Returns mu = tan(phi); 0 if neither is given, which is accepted only if no law reads it.
        [[nodiscard]] double bed_friction_coefficient() const {
            return friction_coefficient ? *friction_coefficient : tangent_of(friction_angle.value_or(0));
        }
    };
    static auto keys() {
        return std::tuple_cat(
            std::tuple{
                law_key(&Values::friction_angle, "material.friction-angle", worded("friction angle"), "degrees",
                        {0, 60}, "Bed friction angle phi; this or friction-coefficient.",
                        "required, or friction-coefficient"),
                law_key(&Values::friction_coefficient, "material.friction-coefficient", worded("friction coefficient"),
                        "", {0, 2}, "Bed friction coefficient mu = tan(phi); typical values are 0.05 to 0.7.",
                        "required, or friction-angle")},
            PoreValues::keys(),
            std::tuple{law_key(&Values::surface_pressure, "material.surface-pressure", "", "Pa", {0, 1e6},
                               "Gauge pressure on the free surface that adds to bed friction; 0 in open air.")});
    }
    static Law row() {
        return {.sentence = worded("Coulomb bed friction"),
                .resists_alike = {"friction of the solid"},
                .resists_with_friction = true};
    }
    static bool acts(const auto& s) {
        return s.material.bed_friction_coefficient() > 0 || s.zones.friction_coefficient;
    }
    static CoulombFriction build(auto& b) {
        return {b.friction_coefficient(), b.material.surface_pressure / b.material.density};
    }
    [[nodiscard]] static bool yields() noexcept { return true; }

    NodeValue friction_coefficient;    ///< tan(phi) [-]
    double pressure_over_density = 0;  ///< p_A / rho [m2/s2]

    void operator()(BedState& bed, std::size_t node) const noexcept {
        bed.yield += friction_coefficient.at(node) *
                     ((1 - bed.pore_pressure) * bed.normal_gravity + pressure_over_density / bed.thickness);
    }
};

}  // namespace frana
