// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/default_values.h"
#include "physics/bed_contact.h"

namespace frana {

/// Erosion by excess of shear stress, down to a depth that grows with it (RAMMS::DEBRIS FLOW):
///
///     rate = E while eroded < e_m, e_m = k (tau - tau_c), for tau > tau_c; otherwise 0      [m/s]
///
/// tau shear stress at the bed, tau_c critical shear stress [Pa], k potential depth per stress [m/Pa], E
/// erosion rate [m/s]; depths vertical. Range: E, k > 0, tau_c >= 0. Limits: at speed zero the bed resistance does not
/// exceed the driving stress, so a mass at rest with tau below tau_c erodes nothing; 0 at depth zero (tau = 0). Source:
/// Frank, McArdell, Huggel, Vieli 2015, Nat. Hazards Earth Syst. Sci. 15, 2569: E = 0.025 m/s, k = 0.1 m/kPa, tau_c = 1
/// kPa.
struct ShearStressErosion {
    static constexpr bool active = true;
    double rate = k_erosion_rate;                ///< E [m/s]
    double critical_shear = k_critical_shear;    ///< tau_c [Pa]
    double potential_depth = k_potential_depth;  ///< k [m/Pa]

    /// Returns the erosion rate [m/s], vertical.
    double operator()(const BedContact& c) const noexcept {
        if (!(c.speed > 0)) return 0;
        const double open = potential_depth * (c.shear - critical_shear) - c.eroded;
        return std::clamp(open / c.time_step, 0.0, rate);
    }
};

}  // namespace frana
