// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/default_values.h"
#include "physics/bed_contact.h"
#include "physics/law.h"

namespace frana {

/// Erosion by the jump of shear stress and velocity across the bed surface:
///
///     rate = (tau - tau_r) / (rho s) for tau > tau_r, otherwise 0      [m/s]
///     tau_r = c + (1 - r_b) sigma tan(phi_b)
///
/// tau shear stress of the flow, tau_r strength of the bed [Pa], c its cohesion [Pa], phi_b its friction
/// angle, r_b its pore pressure over total normal stress sigma [-], rho density [kg/m3], s mean speed [m/s]; the
/// velocity at the base is the mean one. Range: 0 <= r_b <= 1. Limits: at
/// depth zero tau = sigma = 0 and nothing is eroded; the law has no limit at speed zero, so below 0.1 m/s the rate
/// decreases in proportion to s (our choice). Sources: momentum jump at the bed, Fraccarollo and Capart 2002, J. Fluid
/// Mech. 461, 183; Iverson 2012, J. Geophys. Res. 117, F03006; the mechanical erosion rate of Pudasaini and Fischer
/// 2020, Int. J. Multiphase Flow 132, 103416, has this form for one phase with equal densities, with a drift of 1.
struct MechanicalErosion {
    static constexpr bool active = true;
    static constexpr const char* word = "mechanical";
    struct Values {
        std::optional<double> bed_friction_angle, bed_cohesion, bed_pore_pressure_ratio;
    };
    static auto keys() {
        const MechanicalErosion law;
        return std::tuple{
            law_key(&Values::bed_friction_angle, "entrainment.bed-friction-angle", "", "degrees", {0, 60},
                    "Friction angle of the bed's material."),
            law_key(&Values::bed_cohesion, "entrainment.bed-cohesion", "", "Pa", {0, 1e6},
                    "Cohesion of the bed's material.", shortest_text(law.bed_cohesion)),
            law_key(&Values::bed_pore_pressure_ratio, "entrainment.bed-pore-pressure-ratio", "", "", {0, 1},
                    "Pore pressure over total normal stress in the bed.", shortest_text(law.bed_pore_pressure))};
    }
    static Law row() { return {.sentence = worded("mechanical erosion"), .needs = {"entrainment.erodible-depth"}}; }
    static MechanicalErosion build(const auto& e, double density) {
        const MechanicalErosion law;
        return {density, tangent_of(e.bed_friction_angle.value()), e.bed_cohesion.value_or(law.bed_cohesion),
                e.bed_pore_pressure_ratio.value_or(law.bed_pore_pressure)};
    }

    static constexpr double k_slow = 0.1;  ///< [m/s]
    double density = k_flow_density;       ///< [kg/m3]
    double bed_friction = 0.6;             ///< tan(phi_b) [-]
    double bed_cohesion = 0;               ///< c [Pa]
    double bed_pore_pressure = 0;          ///< r_b [-]

    double operator()(const BedContact& c) const noexcept {
        const double strength = bed_cohesion + (1 - bed_pore_pressure) * c.normal * bed_friction;
        const double excess = std::max(0.0, c.shear - strength);
        return excess * c.speed / (density * std::max(c.speed * c.speed, k_slow * k_slow));
    }
};

}  // namespace frana
