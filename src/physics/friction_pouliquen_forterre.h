// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/default_values.h"
#include "physics/law.h"
#include "physics/place_of_value.h"
#include "physics/pore_pressure.h"

namespace frana {

/// Friction of dry grains, increasing with the flow's inertia, mu(I) in its depth-averaged form:
///
///     R(s) = (1 - r) g_n ( mu_1 + (mu_2 - mu_1) / (1 + beta d / (L Fr)) ),   Fr = s / sqrt(g_n d) [m/s2]
///
/// r pore pressure over total normal stress (pore_pressure.h), mu_1 = tan(zeta_1) friction of the slowest steady flow,
/// mu_2 = tan(zeta_2) of the fastest [-], beta = 0.136 and L (of the order of a grain's diameter) [m] of the deposit
/// h_stop, d thickness [m], g_n normal gravity [m/s2]. Range: mu_1 <= mu_2, L > 0; dry grains. Limits: mu_1 g_n is a
/// bound at speed zero; for d
/// -> 0 or fast flow friction is mu_2; without support there is none. Sources: Pouliquen and Forterre 2002,
/// J. Fluid Mech. 453, 133 (the dynamic branch, Fr > beta; continued here to Fr = 0, without their hysteresis at the
/// start of motion); as mu(I): Jop, Forterre, Pouliquen 2006, Nature 441, 727.
struct PouliquenForterreExcess {
    static constexpr const char* word = "pouliquen-forterre";
    struct Values {
        std::optional<double> fast_friction_angle, friction_length, friction_beta;
    };
    static auto keys() {
        return std::tuple{
            law_key(&Values::fast_friction_angle, "material.fast-friction-angle", "", "degrees", {0, 80},
                    "Friction angle of fast, thin flow."),
            law_key(&Values::friction_length, "material.friction-length", "", "m", {0, 100, true},
                    "L of the deposit's thickness."),
            law_key(&Values::friction_beta, "material.friction-beta", "", "", {0, 10, true}, "beta of the flow rule.",
                    shortest_text(PouliquenForterreExcess{}.beta) + ", glass beads")};
    }
    static Law row() {
        return {.sentence = worded("Pouliquen-Forterre bed friction"),
                .reads = PoreValues::names({"material.friction-angle", "material.friction-coefficient"}),
                .resists_alike = {"friction of the solid", "resistance of the fluid"},
                .resists_with_friction = true,  // mu(I) is at least its value at rest
                .angle_from_bed = "material.fast-friction-angle"};
    }
    static PouliquenForterreExcess build(auto& b) {
        const auto& m = b.material;
        return {b.friction_coefficient(), tangent_of(m.fast_friction_angle.value()),
                m.friction_beta.value_or(PouliquenForterreExcess{}.beta), m.friction_length.value()};
    }

    NodeValue slow_coefficient;     ///< mu_1 [-]
    double fast_coefficient = 0.6;  ///< mu_2 [-]
    double beta = 0.136;            ///< [-]
    double length = 1;              ///< L [m]

    void operator()(BedState& bed, std::size_t node) const noexcept {
        bed.yield += (1 - bed.pore_pressure) * slow_coefficient.at(node) * bed.normal_gravity;
    }

    /// Backward Euler with the polynomial parts. s / (s + s_c) is the fraction of mu_2 - mu_1 that acts, s_c =
    /// beta d sqrt(g_n d) / L.
    [[nodiscard]] double speed_after(const BedState& bed, std::size_t node, double left, double dt) const noexcept {
        const double difference = std::max(0.0, fast_coefficient - slow_coefficient.at(node));
        const double most = (1 - bed.pore_pressure) * bed.normal_gravity * difference;
        const double s_c = beta * bed.thickness * std::sqrt(bed.normal_gravity * bed.thickness) / length;
        return place_of_value(
            [&](double s) {
                const double fraction = s / (s + s_c);
                return speed_balance({s, 1}, {most * fraction, most * (1 - fraction) / (s + s_c)}, bed, dt);
            },
            left, left, left);
    }
};

}  // namespace frana
