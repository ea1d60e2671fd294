// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"

namespace frana {

/// How far a mass ran: from the highest point of the release's surface (of the touched bed, where nothing was released
/// but flowed in) to the cell of the trace farthest from it in map view.
struct Runout {
    double horizontal_m = 0;     ///< straight line in map view
    double drop_m = 0;           ///< surface at the top less bed at the tip
    double reach_angle_deg = 0;  ///< atan(drop / horizontal), the angle of reach (Fahrboeschung)
    Point top;                   ///< map coordinates
    Point tip;
};

/// `bed` [m] is what was slid over, `release` the vertical thickness that failed [m] (positive: released),
/// `trace` a mask of the ground touched. All on the same cells. Throws Error(input) when they are not or
/// nothing is released; a trace without cells gives zero length.
Runout runout(const Raster& bed, const Raster& release, const Raster& trace);

}  // namespace frana
