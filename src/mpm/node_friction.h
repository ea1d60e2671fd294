// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "physics/friction_sum.h"
#include "physics/friction_voellmy.h"

namespace frana {

/// Parameters of a step for the nodes' stages.
struct NodeUpdate {
    double dt = 0;                        ///< over which forces act [s]
    double gravity = 0;                   ///< g_z [m/s2]
    double gravity_x = 0, gravity_y = 0;  ///< tilted gravity for verification [m/s2]
    double minimum_depth = 0;             ///< depth from which a node counts in the maxima [m]
    double effective_fraction = 1;        ///< 1 - r_u: effective fraction of the normal stress under pore pressure [-]
    double moving_speed = 0;              ///< speed from which a node's volume counts as moving [m/s]
    bool change_only = false;             ///< particles take the change of the velocity (FLIP), not the velocity
    bool wall = false;                    ///< ghost nodes mirror those inside
    Point* gathered = nullptr;            ///< padded, if recorded: velocity in map view before the update [m/s]
    double drift = 0;                     ///< over which the particles then move [s]
};

/// Friction at the nodes: Voellmy with uniform parameters, nothing stored.
struct UniformFriction {
    static constexpr bool remembers = false;
    const VoellmyFriction& law;

    [[nodiscard]] bool active() const noexcept { return law.active(); }
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
    /// @param supported vertical acceleration supported by the bed, g + load [m/s2]
    [[nodiscard]] double speed_after(std::size_t, double speed, const NodeUpdate& k, double root, double supported,
                                     double depth) const noexcept {
        return law.speed_after(speed, k.dt, supported / root, k.gravity, depth / root);
    }
};

/// The sum of any laws, with parameters that may vary from node to node: each node's BedState, computed before, and at
/// most one law that is not a polynomial of the speed.
template <class Excess>
struct SummedFriction {
    static constexpr bool remembers = true;
    const Excess& excess;
    BedState* states;  ///< padded
    bool yields;       ///< whether any law has a yield part

    [[nodiscard]] bool active() const noexcept { return true; }
    [[nodiscard]] bool keeps_rest() const noexcept { return yields; }
    [[nodiscard]] double stopped_in_step(std::size_t node, const NodeUpdate& k) const noexcept {
        return k.dt * states[node].yield;
    }
    [[nodiscard]] double held(double mass, std::size_t node, double n, double) const noexcept {
        return mass * states[node].yield / std::sqrt(n);
    }
    [[nodiscard]] double held_in_step(const NodeUpdate& k) const noexcept { return k.dt; }
    [[nodiscard]] double speed_after(std::size_t node, double speed, const NodeUpdate& k, double, double,
                                     double) const noexcept {
        const double after = std::min(speed, speed_after_friction(states[node], node, excess, speed, k.dt));
        states[node].resistance = (speed - after) / k.dt;
        return after;
    }
    /// Stores a held node's resistance: it equals the driving force.
    void remember(std::size_t node, double speed, const NodeUpdate& k) const noexcept {
        states[node].resistance = speed / k.dt;
    }
};

}  // namespace frana
