// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/default_values.h"
#include "physics/friction_herschel_bulkley.h"
#include "physics/friction_sum.h"
#include "physics/law.h"
#include "physics/stress_bingham.h"
#include "physics/yield_ratio.h"

namespace frana {

/// Bed resistance of a Bingham fluid with the ratio zeta = tau_Y / tau_B from the quadratic of Fois, de
/// Falco, Formaggia 2024 (equation 9) instead of the cubic:
///
///     48 zeta^2 - (114 + 32 a) zeta + 65 = 0,   a = 6 mu s / (tau_Y d),   R = tau_Y / (zeta rho d) [m/s2]
///
/// mu viscosity [Pa s], tau_Y yield stress [Pa], d thickness [m], s mean speed [m/s], rho density [kg/m3].
/// Range: tau_Y > 0, mu > 0. Limits: at speed zero zeta is 0.951, so that the bound is 1.051 tau_Y / (rho d); for d ->
/// 0 the flow stops. The exact root is in friction_herschel_bulkley.h with m = 1.
struct BinghamQuadraticExcess {
    double density = k_flow_density;  ///< [kg/m3]
    double yield_stress = 100;        ///< tau_Y [Pa]
    double viscosity = 10;            ///< mu [Pa s]

    /// Returns the bed stress at rest, this law's bound [Pa].
    [[nodiscard]] double bound() const noexcept { return yield_stress / QuadraticYieldRatio{}(0.0); }

    void operator()(BedState& bed, std::size_t) const noexcept { bed.yield += bound() / (density * bed.thickness); }

    /// Returns the mean speed under a bed stress that exceeds the bound by x [Pa], the quadratic solved for a, and its
    /// derivative.
    [[nodiscard]] ValueAndSlope speed(double x, double thickness) const noexcept {
        if (!(x > 0)) return {0, 0};
        const double zeta = yield_stress / (bound() + x), scale = thickness / (6 * viscosity);
        const double a = (48 * zeta * zeta - 114 * zeta + 65) / (32 * zeta);
        return {std::max(0.0, a) * yield_stress * scale, (65 - 48 * zeta * zeta) / 32 * scale};
    }

    [[nodiscard]] double speed_after(const BedState& bed, std::size_t, double left, double dt) const noexcept {
        const double mass = density * bed.thickness;
        const double x = place_of_value(
            [&](double excess) {
                return speed_balance(speed(excess, bed.thickness), {excess / mass, 1 / mass}, bed, dt);
            },
            left, left * mass / dt, 3 * viscosity * left / bed.thickness);
        return std::min(left, speed(x, bed.thickness).value);
    }
};

/// Bed resistance of a Bingham fluid: exact, or with that quadratic.
struct BinghamFriction {
    static constexpr const char* word = BinghamStress::word;
    static Law row() {
        return {.sentence = worded("Bingham bed resistance"),
                .reads = {"material.yield-stress", "material.yield-ratio"},
                .needs = {"material.viscosity"},
                .resists_alike = {"resistance of the fluid"}};
    }
    template <class Builder>
    static std::variant<HerschelBulkleyExcess, BinghamQuadraticExcess> build(const Builder& b) {
        const auto& m = b.material;
        if (m.exact_yield_ratio) return HerschelBulkleyExcess{m.density, m.yield_stress, m.viscosity, 1};
        return BinghamQuadraticExcess{m.density, m.yield_stress, m.viscosity};
    }
};

}  // namespace frana
