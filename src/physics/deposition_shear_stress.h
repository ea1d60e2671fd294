// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "physics/bed_contact.h"
#include "physics/law.h"

namespace frana {

/// Deposition where the shear stress is below that which keeps material moving:
///
///     rate = w (1 - tau / tau_d) for tau < tau_d, otherwise 0      [m/s]
///
/// w deposition rate of material at rest [m/s], tau shear stress with which the bed resists, tau_d the stress from
/// which nothing settles [Pa]; depths vertical. Range: w, tau_d > 0. Limits: at speed zero tau equals the driving
/// stress, so a mass at rest on level ground settles at w and one on a slope may stay; at depth zero there is nothing
/// to deposit. Source: the form of Krone 1962 (Flume studies of the transport of sediment in estuarial shoaling
/// processes, Univ. of California, Berkeley), there for cohesive sediment with w its settling velocity times
/// concentration; its use for mass flows is our extension.
struct ShearStressDeposition {
    static constexpr bool active = true;
    static constexpr const char* word = "on";
    struct Values {
        std::optional<double> deposition_rate, deposition_shear;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::deposition_rate, "entrainment.deposition-rate", "", "m/s", {0, 10, true},
                                  "Deposition rate at zero shear stress."),
                          law_key(&Values::deposition_shear, "entrainment.deposition-shear-stress", "", "Pa",
                                  {0, 1e6, true}, "Shear stress above which there is no deposition.")};
    }
    static Law row() { return {.sentence = worded("deposition under a critical shear stress")}; }
    static ShearStressDeposition build(const auto& e, double) {
        return {e.deposition_rate.value(), e.deposition_shear.value()};
    }

    double rate = 0.01;            ///< w [m/s]
    double critical_shear = 1000;  ///< tau_d [Pa]

    double operator()(const BedContact& c) const noexcept { return rate * std::max(0.0, 1 - c.shear / critical_shear); }
};

}  // namespace frana
