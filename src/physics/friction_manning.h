// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/default_values.h"
#include "physics/bed_state.h"
#include "physics/law.h"

namespace frana {

/// Manning's resistance of a wide, rough channel:
///
///     R(s) = g n^2 s^2 / d^(4/3)      [m/s2]
///
/// n Manning roughness [s/m^(1/3)], d thickness [m], s speed [m/s]. Range: fully rough, turbulent flow; n
/// 0.01 to 0.2. Limits: 0 at speed zero; infinitely stiff for d -> 0, applied implicitly. Source: Chow, Open-Channel
/// Hydraulics, 1959, section 5-6, hydraulic radius = depth. This is the factor of s^2 [1/m].
inline double manning_resistance(double gravity, double manning, double thickness) noexcept {
    return gravity * manning * manning / (thickness * std::cbrt(thickness));
}

/// Manning's resistance as a term of the sum.
struct ManningFriction {
    static constexpr const char* word = "manning";
    struct Values {
        std::optional<double> manning;
    };
    static auto keys() {
        return std::tuple{
            law_key(&Values::manning, "material.manning", "Manning n", "s/m^(1/3)", {0, 1, true}, "Manning's n.")};
    }
    static Law row() { return {.sentence = worded("Manning bed resistance")}; }
    static ManningFriction build(const auto& b) { return {b.gravity, b.material.manning.value()}; }
    [[nodiscard]] static bool yields() noexcept { return false; }

    double gravity = k_standard_gravity;  ///< [m/s2]
    double manning = 0.05;                ///< n [s/m^(1/3)]

    void operator()(BedState& bed, std::size_t) const noexcept {
        bed.square += manning_resistance(gravity, manning, bed.thickness);
    }
};

}  // namespace frana
