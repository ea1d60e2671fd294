// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/default_values.h"
#include "physics/law.h"
#include "physics/place_of_value.h"

namespace frana {

/// Bed resistance of a Herschel-Bulkley fluid, tau = tau_Y + K (du/dz)^m, in steady simple shear: the bed stress tau_B
/// for the mean speed s of a plug over a sheared zone,
///
///     s = d/(1 + 1/m) (x / K)^(1/m) (x / tau_B) ( 1 - x / ((2 + 1/m) tau_B) ),   x = tau_B - tau_Y
///     R = tau_B / (rho d)      [m/s2]
///
/// d thickness [m], K consistency [Pa s^m], m flow index [-], rho density [kg/m3]. m = 1 is Bingham, and then
/// the same as the cubic zeta^3 - (3 + a) zeta + 2 = 0 with zeta = tau_Y / tau_B and a = 6 K s / (tau_Y d);
/// tau_Y = 0 is a power-law fluid, with m = 1 R = 3 K s / (rho d^2). Range: K > 0, 0.1 <= m <= 2, laminar
/// flow. Limits: tau_Y is a bound at speed zero; for d -> 0 the flow stops. Applied implicitly, with the
/// stress as the unknown. Sources: Coussot 1994, J. Hydraul. Res. 32, 535; Huang and Garcia 1998, J. Fluid
/// Mech. 374, 305.
struct HerschelBulkleyExcess {
    static constexpr const char* word = "herschel-bulkley";
    struct Values {
        std::optional<double> consistency, flow_index;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::consistency, "material.consistency", worded("consistency"), "Pa s^m",
                                  {0, 1e8, true}, "Herschel-Bulkley K."),
                          law_key(&Values::flow_index, "material.flow-index", worded("flow index"), "", {0.1, 2},
                                  "Herschel-Bulkley m.")};
    }
    static Law row() {
        return {.sentence = worded("Herschel-Bulkley bed resistance"),
                .reads = {"material.yield-stress"},
                .resists_alike = {"resistance of the fluid"}};
    }
    static HerschelBulkleyExcess build(const auto& b) {
        const auto& m = b.material;
        return {m.density, m.yield_stress, m.consistency.value(), m.flow_index.value()};
    }

    double density = k_flow_density;  ///< [kg/m3]
    double yield_stress = 0;          ///< tau_Y [Pa]
    double consistency = 1;           ///< K [Pa s^m]
    double flow_index = 1;            ///< m [-]

    /// Adds the yield part, tau_Y / (rho d).
    void operator()(BedState& bed, std::size_t) const noexcept {
        bed.yield += yield_stress / (density * bed.thickness);
    }

    /// Returns the mean speed under a bed stress that exceeds the yield stress by x [Pa], and its derivative.
    [[nodiscard]] ValueAndSlope speed(double x, double thickness) const noexcept {
        if (!(x > 0)) return {0, 0};
        const double p = 1 / flow_index, stress = yield_stress + x, fraction = x / stress;
        const double rate = flow_index == 1 ? x / consistency : std::pow(x / consistency, p);
        const double s = thickness * rate * fraction / (1 + p) * (1 - fraction / (2 + p));
        return {s, s * p / x + thickness * rate / (1 + p) * (1 - fraction) / stress * (1 - 2 * fraction / (2 + p))};
    }

    /// Backward Euler: the speed at excess x, plus the reductions by all parts, equals `left`.
    [[nodiscard]] double speed_after(const BedState& bed, std::size_t, double left, double dt) const noexcept {
        const double mass = density * bed.thickness;
        const double x = place_of_value(
            [&](double excess) {
                return speed_balance(speed(excess, bed.thickness), {excess / mass, 1 / mass}, bed, dt);
            },
            left, left * mass / dt,
            consistency * std::pow(2 * (1 + 1 / flow_index) * left / bed.thickness, flow_index));
        return std::min(left, speed(x, bed.thickness).value);
    }
};

}  // namespace frana
