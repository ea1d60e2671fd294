// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/bed_contact.h"
#include "physics/law.h"

namespace frana {

/// Erosion in proportion to the flux over the bed, so that the volume grows exponentially with the distance travelled:
///
///     rate = E_s h s      [m/s],   V = V_0 exp(E_s S)
///
/// E_s growth rate [1/m] (logarithm of final over initial volume, over the length of the path), h depth [m], s speed
/// along the bed [m/s], S distance along the bed [m]. Range: E_s > 0, typically 1e-4 to 1e-2. Limits: 0 at depth zero
/// and at speed zero. Source: McDougall and Hungr 2005, Can. Geotech. J. 42, 1437.
struct GrowthErosion {
    static constexpr bool active = true;
    static constexpr const char* word = "growth";
    struct Values {
        std::optional<double> growth_rate;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::growth_rate, "entrainment.growth-rate", "", "1/m", {0, 1, true},
                                  "Volume growth rate per distance.")};
    }
    static Law row() {
        return {.sentence = worded("erosion by exponential growth"), .needs = {"entrainment.erodible-depth"}};
    }
    static GrowthErosion build(const auto& e, double) { return {e.growth_rate.value()}; }

    double growth_rate = 1e-3;  ///< E_s [1/m]

    double operator()(const BedContact& c) const noexcept { return growth_rate * c.depth * c.speed; }
};

}  // namespace frana
