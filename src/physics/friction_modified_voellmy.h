// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "physics/friction_sum.h"
#include "physics/friction_turbulence.h"
#include "physics/law.h"
#include "physics/pore_pressure.h"

namespace frana {

/// Voellmy's friction with its two parts in two regimes of speed, instead of their sum:
///
///     R(s) = (1 - r) mu g_n      where s < v_c
///     R(s) = g s^2 / (xi d)      where s >= v_c,      v_c = v_1 (d / 1 m)^(1/3)      [m/s2]
///
/// mu friction coefficient [-], r pore pressure over total normal stress [-], xi turbulence coefficient [m/s2], v_1
/// crossover speed where the flow is 1 m thick [m/s], d thickness normal to the bed [m], g_n normal gravity [m/s2]. A
/// thick flow keeps to the second regime, in which resistance falls with thickness, for longer: run-out grows with
/// volume while the parameters stay. Range: v_1 > 0; rock avalanches; the author's program has mu 0.2, xi 500 m/s2 and
/// v_1 4 m/s. Limits: mu (1 - r) g_n is a bound at speed zero; for d -> 0 v_c falls to 0 and the second regime, then
/// infinitely stiff, brings the film to it at once. The regime is that of the speed at the middle of the step without
/// friction. Sources: Hergarten 2024, Geosci. Model Dev. 17, 781, and Earth Surf. Dynam. 12, 219: their abstracts, and
/// the equations in the author's program (MinVoellmy, version 2).
struct ModifiedVoellmyExcess {
    static constexpr const char* word = "modified-voellmy";
    struct Values {
        std::optional<double> crossover_speed;
    };
    static auto keys() {
        return std::tuple{law_key(&Values::crossover_speed, "material.crossover-speed", "", "m/s", {0, 100, true},
                                  "Speed from which turbulence instead of friction resists, 1 m thick.")};
    }
    static Law row() {
        return {.sentence = worded("modified Voellmy bed friction"),
                .reads = PoreValues::names({"material.friction-angle", "material.friction-coefficient"}),
                .needs = {"material.turbulence"},
                .resists_alike = {"friction of the solid", "resistance of the fluid", "turbulent resistance"}};
    }
    static ModifiedVoellmyExcess build(auto& b) {
        return {b.gravity, b.friction_coefficient(), b.turbulence(), b.material.crossover_speed.value()};
    }

    double gravity = k_standard_gravity;  ///< [m/s2]
    NodeValue friction_coefficient;       ///< mu [-]
    NodeValue turbulence;                 ///< xi [m/s2]
    double crossover_speed = 4;           ///< v_1 [m/s]

    [[nodiscard]] double friction(const BedState& bed, std::size_t node) const noexcept {
        return (1 - bed.pore_pressure) * friction_coefficient.at(node) * bed.normal_gravity;
    }
    void operator()(BedState& bed, std::size_t node) const noexcept { bed.yield += friction(bed, node); }

    /// Backward Euler with the polynomial parts. `left` has lost this law's yield: in the second regime it gets it
    /// back.
    [[nodiscard]] double speed_after(const BedState& bed, std::size_t node, double left, double dt) const noexcept {
        const double free = left + dt * friction(bed, node), b = 1 + dt * bed.linear;
        if (free < crossover_speed * std::cbrt(bed.thickness)) return left / implicit_divisor(left, b, dt * bed.square);
        const double square = bed.square + turbulent_resistance(gravity, 1 / turbulence.at(node), bed.thickness);
        return free / implicit_divisor(free, b, dt * square);
    }
};

}  // namespace frana
