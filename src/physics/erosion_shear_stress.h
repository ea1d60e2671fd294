// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/default_values.h"
#include "physics/bed_contact.h"
#include "physics/law.h"

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
    double rate = 0.025;            ///< E [m/s]
    double critical_shear = 1000;   ///< tau_c [Pa]
    double potential_depth = 1e-4;  ///< k [m/Pa]

    static constexpr const char* word = "shear-stress";
    struct Values {
        std::optional<double> erosion_rate, critical_shear, erosion_depth_per_kpa;
    };
    static auto keys() {
        const ShearStressErosion law;
        return std::tuple{
            law_key(&Values::erosion_rate, "entrainment.erosion-rate", "", "m/s", {0, 10, true}, "Erosion rate.",
                    shortest_text(law.rate)),
            law_key(&Values::critical_shear, "entrainment.critical-shear-stress", "", "Pa", {0, 1e6},
                    "Shear stress above which the bed erodes.", shortest_text(law.critical_shear)),
            law_key(&Values::erosion_depth_per_kpa, "entrainment.erosion-depth-per-stress", "", "m/kPa", {0, 100, true},
                    "Maximum eroded depth per kPa of shear stress above critical-shear-stress.",
                    shortest_text(1e3 * law.potential_depth))};
    }
    static Law row() {
        return {.sentence = worded("erosion by excess shear stress"), .needs = {"entrainment.erodible-depth"}};
    }
    static ShearStressErosion build(const auto& e, double) {
        ShearStressErosion law;
        law.rate = e.erosion_rate.value_or(law.rate);
        law.critical_shear = e.critical_shear.value_or(law.critical_shear);
        if (e.erosion_depth_per_kpa) law.potential_depth = *e.erosion_depth_per_kpa * 1e-3;
        return law;
    }

    /// Returns the erosion rate [m/s], vertical.
    double operator()(const BedContact& c) const noexcept {
        if (!(c.speed > 0)) return 0;
        const double open = potential_depth * (c.shear - critical_shear) - c.eroded;
        return std::clamp(open / c.time_step, 0.0, rate);
    }
};

}  // namespace frana
