// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/default_values.h"
#include "physics/bed_state.h"
#include "physics/law.h"

namespace frana {

/// Chezy's resistance of a wide, rough channel:
///
///     R(s) = g s^2 / (C^2 d)      [m/s2]
///
/// C Chezy coefficient [m^(1/2)/s], d thickness [m], s speed [m/s]. Range: fully rough, turbulent flow; C 10
/// to 100. Limits: 0 at speed zero; infinitely stiff for d -> 0, applied implicitly. Source: Chow, Open-Channel
/// Hydraulics, 1959, section 5-4, with the friction slope s^2 / (C^2 d).
struct ChezyFriction {
    static constexpr const char* word = "chezy";
    struct Values {
        std::optional<double> chezy;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::chezy, "material.chezy", "Chezy C", "m^(1/2)/s", {0.1, 1000}, "Chezy's C.")};
    }
    static Law row() { return {.sentence = worded("Chezy bed resistance")}; }
    static ChezyFriction build(const auto& b) { return {b.gravity, b.material.chezy.value()}; }
    [[nodiscard]] static bool yields() noexcept { return false; }

    double gravity = k_standard_gravity;  ///< [m/s2]
    double chezy = 30;                    ///< C [m^(1/2)/s]

    void operator()(BedState& bed, std::size_t) const noexcept {
        bed.square += gravity / (chezy * chezy * bed.thickness);
    }
};

}  // namespace frana
