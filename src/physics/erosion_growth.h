// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/bed_contact.h"

namespace frana {

/// Erosion in proportion to what flows over the bed, so that a flow grows exponentially with the way it goes:
///
///     rate = E_s h s      [m/s],   V = V_0 exp(E_s S)
///
/// E_s growth rate [1/m] (logarithm of final over first volume, over the length of the path), h depth [m], s
/// speed along the bed [m/s], S way along the bed [m]. Range: E_s > 0, customarily 1e-4 to 1e-2. Limits:
/// nothing at depth zero nor at speed zero. Source: McDougall and Hungr 2005, Can. Geotech. J. 42, 1437.
struct GrowthErosion {
    static constexpr bool active = true;
    double growth_rate = 1e-3;  ///< E_s [1/m]

    double operator()(const BedContact& c) const noexcept { return growth_rate * c.depth * c.speed; }
};

}  // namespace frana
