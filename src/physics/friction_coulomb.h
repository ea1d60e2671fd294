// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/bed_state.h"

namespace frana {

/// Coulomb friction with pore pressure and surface pressure:
///
///     R = tan(phi) ( (1 - r_u) g_n + p_A / (rho d) )      [m/s2]
///
/// phi friction angle of the bed, r_u pore pressure over total normal stress [-], p_A gauge pressure on the
/// free surface [Pa]. Range: tan(phi) 0 to 2, r_u 0 to 1. Limits: all of it is yield; at speed zero it holds material
/// driven by less; without support (g_n = 0) only the surface pressure acts; for d -> 0 the surface pressure holds all
/// material. Sources: Savage and Hutter 1989 (friction); Hungr 1995, Can. Geotech. J. 32, 610 (r_u); p_A: Fois, de
/// Falco, Formaggia 2024, equation 2.
struct CoulombFriction {
    NodeValue friction_coefficient;    ///< tan(phi) [-]
    double effective_fraction = 1;     ///< 1 - r_u [-]
    double pressure_over_density = 0;  ///< p_A / rho [m2/s2]

    void operator()(BedState& bed, std::size_t node) const noexcept {
        bed.yield += friction_coefficient.at(node) *
                     (effective_fraction * bed.normal_gravity + pressure_over_density / bed.thickness);
    }
};

}  // namespace frana
