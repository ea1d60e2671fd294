// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

namespace frana {

/// The state at a place that laws of bed friction use, and the sum of their parts, a deceleration of the speed s along
/// the bed:
///
///     R(s) = yield + linear s + square s^2 (+ an excess law)      [m/s2]
///
/// `yield` is a bound, not a force: material driven by less stays at rest. Each law adds its parts and reads nothing
/// that another law has added, so the order of laws does not matter.
struct BedState {
    double thickness;       ///< d, normal to the bed [m]; greater than 0
    double normal_gravity;  ///< support by the bed over mass, g_n = g cos(theta) + v.K.v; never negative [m/s2]
    double yield;           ///< [m/s2]
    double linear;          ///< [1/s]
    double square;          ///< [1/m]
    double resistance;      ///< after the nodes' update: the resistance that acted, over mass [m/s2]
    double pore_pressure;   ///< over the total normal stress, r [-]
};

/// A parameter of a law: uniform, or one value per node.
struct NodeValue {
    double uniform = 0;
    const double* nodes = nullptr;  ///< padded as the nodes are; none: uniform

    [[nodiscard]] double at(std::size_t node) const noexcept { return nodes ? nodes[node] : uniform; }
};

}  // namespace frana
