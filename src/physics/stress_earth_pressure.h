// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/default_values.h"
#include "physics/law.h"
#include "physics/strain_rate.h"

namespace frana {

/// Earth pressure of a granular mass sliding on its bed: the pressure in the plane is K times that of the weight,
///
///     K_act, K_pass = 2 ( 1 -+ sqrt( 1 - cos^2(phi_i) (1 + tan^2(delta)) ) ) / cos^2(phi_i) - 1
///     sigma = -(K - 1) g h / 2 I, over density      [m2/s2]
///
/// phi_i internal friction angle, delta friction angle of the bed, h depth [m]. K is K_act where the mass spreads and
/// K_pass where it is compressed, equal in both directions of the plane, by the sign of div v; between -r and r it is
/// interpolated through K(0), which is 1 or the nearer of the two. Range: delta <= phi_i. Limits: phi_i = delta gives K
/// = 1 + 2 tan^2(delta) for both; at rest K(0); 0 at depth 0. Sources: Savage and Hutter 1989, J. Fluid Mech. 199, 177
/// (the coefficients); isotropic by the sign of div v: Iverson and Denlinger 2001, J. Geophys. Res. 106, 537. The
/// transition is our addition: without it K jumps with the last digit of div v.
struct EarthPressureStress {
    static constexpr bool active = true;
    static constexpr const char* word = "earth-pressure";
    struct Values {
        std::optional<double> internal_friction_angle;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::internal_friction_angle, "material.internal-friction-angle",
                                  worded("internal friction angle"), "degrees", {0, 60, true},
                                  "Internal friction angle of earth pressure, at least that of the bed.")};
    }
    static Law row() {
        return {.sentence = worded("earth pressure"),
                .reads = {"material.friction-angle", "material.friction-coefficient"},
                .angle_from_bed = "material.internal-friction-angle"};
    }
    static EarthPressureStress build(const auto& m, double gravity) {
        return of(tangent_of(m.internal_friction_angle.value()), m.bed_friction_coefficient(), gravity);
    }
    /// Returns the square of the factor on the speed of pressure waves.
    [[nodiscard]] double wave_factor() const noexcept { return std::max(1.0, compressed); }

    double gravity = k_standard_gravity;  ///< [m/s2]
    double spreading = 1;                 ///< K_act [-]
    double compressed = 1;                ///< K_pass [-]
    double transition = 1e-3;             ///< r [1/s]

    /// @param internal_friction tan(phi_i), at least @param bed_friction tan(delta)
    static EarthPressureStress of(double internal_friction, double bed_friction, double gravity) noexcept {
        const double secant2 = 1 + internal_friction * internal_friction;
        const double root = std::sqrt(std::max(0.0, 1 - (1 + bed_friction * bed_friction) / secant2));
        return {gravity, 2 * (1 - root) * secant2 - 1, 2 * (1 + root) * secant2 - 1};
    }

    template <class Number>
    [[nodiscard, gnu::always_inline]] Number coefficient(Number divergence) const noexcept {
        using std::max;
        using std::min;
        const Number fraction = min(max(divergence / transition, Number(-1.0)), Number(1.0));
        const Number still(std::min(std::max(1.0, spreading), compressed));
        return select(fraction > 0, still + fraction * (spreading - still), still - fraction * (compressed - still));
    }

    template <class Number>
    [[nodiscard, gnu::always_inline]] PlaneStress<Number> operator()(const StrainRate<Number>& rate) const noexcept {
        const Number stress = -0.5 * (coefficient<Number>(rate.xx + rate.yy) - 1) * gravity * rate.depth;
        return {stress, Number(0.0), stress, Number(0.0)};
    }
};

}  // namespace frana
