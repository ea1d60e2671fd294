// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "physics/bed_state.h"
#include "physics/law.h"

namespace frana {

/// The turbulent part of Voellmy's friction:
///
///     R(s) = g s^2 / (xi d)      [m/s2]
///
/// xi turbulence coefficient [m/s2], d thickness normal to the bed [m], s speed along the bed [m/s]. Range:
/// xi > 0; infinite: off. Limits: 0 at speed zero; infinitely stiff for d -> 0, so it is applied implicitly. Source:
/// Voellmy 1955; Fois, de Falco, Formaggia 2024, equation 2. Chezy's law is the same with xi = C^2. This is the factor
/// of s^2 [1/m].
///
/// @param inverse_turbulence 1 / xi
template <class Number>
[[gnu::always_inline]] inline Number turbulent_resistance(double gravity, double inverse_turbulence, Number thickness) {
    return gravity * inverse_turbulence / thickness;
}

/// The turbulent part as a term of the sum.
struct TurbulentFriction {
    static constexpr const char* word = "turbulence";
    struct Values {
        std::optional<double> turbulence;

        /// Returns 1 / xi; 0: off.
        [[nodiscard]] double inverse_turbulence() const { return turbulence ? 1 / *turbulence : 0; }
    };
    static auto keys() {
        return std::tuple{law_key(&Values::turbulence, "material.turbulence", worded("turbulence"), "m/s2",
                                  {0, 1e9, true}, "Voellmy turbulence coefficient xi; off: friction alone.", "off",
                                  true)};
    }
    static Law row() {
        return {.sentence = worded("turbulent bed friction"), .resists_alike = {"turbulent resistance"}};
    }
    static bool acts(const auto& s) { return s.material.inverse_turbulence() > 0 || s.zones.turbulence; }
    static TurbulentFriction build(auto& b) { return {b.gravity, b.turbulence()}; }
    [[nodiscard]] static bool yields() noexcept { return false; }

    double gravity = k_standard_gravity;  ///< [m/s2]
    NodeValue turbulence;                 ///< xi [m/s2]

    void operator()(BedState& bed, std::size_t node) const noexcept {
        bed.square += turbulent_resistance(gravity, 1 / turbulence.at(node), bed.thickness);
    }
};

}  // namespace frana
