// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "core/lanes.h"
#include "physics/bed_state.h"
#include "physics/friction_sum.h"
#include "physics/parameters.h"

namespace frana {

/// Parameters of a step for the nodes' stages.
struct NodeUpdate {
    double dt = 0;                        ///< over which forces act [s]
    double gravity = 0;                   ///< g_z [m/s2]
    double gravity_x = 0, gravity_y = 0;  ///< tilted gravity for verification [m/s2]
    double minimum_depth = 0;             ///< depth from which a node counts in the maxima [m]
    const double* pore_sums = nullptr;    ///< padded: sum of w V r, r of pore_pressure.h [m3]; null: no pore pressure
    double moving_speed = 0;              ///< speed from which a node's volume counts as moving [m/s]
    double kept = 0;                      ///< share of its own velocity that a particle keeps in a step: nodes return
                                          ///< theirs without it (PIC and APIC: 0, FLIP: 1)
    bool wall = false;                    ///< ghost nodes mirror those inside
    Point* gathered = nullptr;            ///< padded, if recorded: velocity in map view before the update [m/s]
    double drift = 0;                     ///< over which the particles then move [s]
};

/// Friction at the nodes: Voellmy with uniform parameters, nothing stored.
struct UniformFriction {
    const VoellmyFriction& law;

    [[nodiscard]] bool keeps_rest() const noexcept { return law.friction_coefficient > 0; }
    /// Returns the reduction of speed by yield in a step [m/s].
    [[nodiscard]] double stopped_in_step(std::size_t, const NodeUpdate& k) const noexcept {
        return k.dt * law.friction_coefficient * k.gravity;
    }
    /// Returns a node's contribution to the static friction bound: in map view the bound (g + load) tan(phi) / sqrt(n)
    /// acts over sqrt(n).
    [[nodiscard]] double held(double mass, std::size_t, double n, double supported) const noexcept {
        return mass * supported / n;
    }
    /// Returns the factor that converts the sum of contributions to a momentum.
    [[nodiscard]] double held_in_step(const NodeUpdate& k) const noexcept { return k.dt * law.friction_coefficient; }
    /// Returns the speed after the step of `count` nodes from `node` on; 0 where they are held.
    /// @param start speed before the step, @param driven the same after its driving forces [m/s]
    /// @param supported vertical acceleration supported by the bed, g + load [m/s2]
    template <class Number>
    [[nodiscard, gnu::always_inline]] Number speed_after(std::size_t, std::size_t, Number start, Number driven,
                                                         typename Lanes<Number>::Mask held, const NodeUpdate& k,
                                                         Number root, Number supported, Number depth) const {
        if (!law.active()) return select(held, Number(0.0), driven);
        return select(held, Number(0.0),
                      law.template speed_after<Number>(start, driven, k.dt, supported / root, k.gravity, depth / root));
    }
};

/// The sum of any laws, with parameters that may vary from node to node: each node's BedState, computed before, and at
/// most one law that is not a polynomial of the speed.
template <class Excess>
struct SummedFriction {
    const Excess& excess;
    BedState* states;  ///< padded
    bool yields;       ///< whether any law has a yield part

    [[nodiscard]] bool keeps_rest() const noexcept { return yields; }
    [[nodiscard]] double stopped_in_step(std::size_t node, const NodeUpdate& k) const noexcept {
        return k.dt * states[node].yield;
    }
    [[nodiscard]] double held(double mass, std::size_t node, double n, double) const noexcept {
        return mass * states[node].yield / std::sqrt(n);
    }
    [[nodiscard]] double held_in_step(const NodeUpdate& k) const noexcept { return k.dt; }
    /// The same; remembers the resistance: that of a held node equals the driving force.
    template <class Number>
    [[nodiscard, gnu::always_inline]] Number speed_after(std::size_t node, std::size_t count, Number start,
                                                         Number driven, typename Lanes<Number>::Mask held,
                                                         const NodeUpdate& k, Number, Number, Number) const {
        using L = Lanes<Number>;
        Number after = 0.0;
        if constexpr (std::is_same_v<Excess, NoExcess>) {
            Number yield = 0.0, linear = 0.0, square = 0.0, thickness = 1.0;
            for (std::size_t i = 0; i < count; ++i) {
                const BedState& bed = states[node + i];
                L::set(yield, static_cast<int>(i), bed.yield);
                L::set(linear, static_cast<int>(i), bed.linear);
                L::set(square, static_cast<int>(i), bed.square);
                L::set(thickness, static_cast<int>(i), bed.thickness);
            }
            const Number gain = driven - start - k.dt * yield;
            after = select(thickness > 0, speed_after_step<Number>(start, gain, k.dt * linear, k.dt * square), after);
        } else {
            static_assert(std::is_same_v<Number, double>);
            after = speed_after_friction(states[node], node, excess, start, driven, k.dt);
        }
        using std::min;
        after = select(held, Number(0.0), min(driven, after));
        for (std::size_t i = 0; i < count; ++i)
            states[node + i].resistance = L::at(driven - after, static_cast<int>(i)) / k.dt;
        return after;
    }
};

}  // namespace frana
