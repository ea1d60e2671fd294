// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

/// What the laws of erosion and deposition see of a flow and its bed.
struct BedContact {
    double depth;      ///< vertical [m]
    double speed;      ///< along the bed [m/s]
    double shear;      ///< stress with which the bed really resists the flow, tau [Pa]
    double normal;     ///< stress normal to the bed, sigma [Pa]
    double eroded;     ///< so far, vertical [m]
    double time_step;  ///< [s]
};

/// No erosion, or no deposition.
struct NoExchange {
    static constexpr bool active = false;
    double operator()(const BedContact&) const noexcept { return 0; }
};

}  // namespace frana
