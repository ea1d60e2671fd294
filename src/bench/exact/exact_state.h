// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana::bench {

inline constexpr double k_gravity = 9.81;  ///< of every case [m/s2]
inline constexpr double k_degree = 0.017453292519943295;

/// Depth and momentum of an exact solution at a node.
struct ExactState {
    double depth = 0, qx = 0, qy = 0;
};

}  // namespace frana::bench
