// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

namespace frana {

/// What the laws of bed friction see at a place, and what they add up to there, as a deceleration of the
/// speed s along the bed:
///
///     R(s) = yield + linear s + square s^2 (+ an excess law)      [m/s2]
///
/// `yield` is a bound, not a force: what drives less than it stays at rest. Each law adds its parts and reads
/// nothing that another law has added, so their order does not matter.
struct BedState {
    double thickness;       ///< d, normal to the bed [m]; greater than 0
    double normal_gravity;  ///< support by the bed over mass, g_n = g cos(theta) + v.K.v; never negative [m/s2]
    double yield;           ///< [m/s2]
    double linear;          ///< [1/s]
    double square;          ///< [1/m]
    double resistance;      ///< after the nodes' update: what the bed really resisted, over mass [m/s2]
};

/// A parameter of a law: the same everywhere, or one value a node.
struct NodeValue {
    double uniform = 0;
    const double* nodes = nullptr;  ///< padded like the nodes; none: uniform

    [[nodiscard]] double at(std::size_t node) const noexcept { return nodes ? nodes[node] : uniform; }
};

}  // namespace frana
