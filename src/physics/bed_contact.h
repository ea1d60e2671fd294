// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

/// The state of flow and bed that laws of erosion and deposition use.
struct BedContact {
    double depth;      ///< vertical [m]
    double speed;      ///< along the bed [m/s]
    double shear;      ///< stress with which the bed resists the flow, tau [Pa]
    double normal;     ///< stress normal to the bed, sigma [Pa]
    double eroded;     ///< so far, vertical [m]
    double time_step;  ///< [s]
};

struct NoExchange {
    static constexpr bool active = false;
    double operator()(const BedContact&) const noexcept { return 0; }
};

}  // namespace frana
