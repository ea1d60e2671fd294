// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "physics/law.h"

namespace frana {

/// Detrainment by forest: trees hold back snow, the more the slower it flows between them:
///
///     d' = -K / (rho s)      [m/s], of the thickness normal to the bed
///
/// K detrainment coefficient of the stand [Pa], rho density of the flow [kg/m3], s speed along the bed [m/s]. What is
/// held leaves with its momentum, so that the speed of the rest stays. Range: K >= 0, 0 where no forest stands. Limits:
/// towards speed zero the rate has no bound, what creeps is held as a whole; what does not move stays in the flow; at
/// depth zero there is nothing to hold. Source: Feistl, Bebi, Teich, Buehler, Christen, Thuro, Bartelt 2014, J.
/// Glaciol. 60, 124, in the form that com1DFA of AvaFrame gives; the paper itself was not read.
struct ForestDetrainment {
    static constexpr bool active = true;
    static constexpr const char* word = "on";
    struct Values {
        std::optional<double> detrainment_coefficient;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::detrainment_coefficient, "entrainment.detrainment-coefficient", "", "Pa",
                                  {0, 1e4}, "Detrainment coefficient K of forest, everywhere.")};
    }
    static Law row() { return {.sentence = worded("detrainment by forest")}; }
    static ForestDetrainment build(const auto&, double density) { return {density}; }

    double density = k_flow_density;  ///< rho [kg/m3]

    /// Returns the rate [m/s], vertical.
    /// @param coefficient K [Pa]  @param speed s > 0  @param stretch area of the bed over that of the map, 1 / cos
    double operator()(double coefficient, double speed, double stretch) const noexcept {
        return coefficient * stretch / (density * speed);
    }
};

}  // namespace frana
