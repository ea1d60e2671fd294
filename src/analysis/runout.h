// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"

namespace frana {

/// Run-out of a mass: from the highest point of the release's surface (of the reached bed, where material only flowed
/// in) to the cell of the trace farthest from it in map view.
struct Runout {
    double horizontal_m = 0;     ///< straight line in map view
    double drop_m = 0;           ///< surface at the top minus bed at the tip
    double reach_angle_deg = 0;  ///< atan(drop / horizontal), the angle of reach (Fahrboeschung)
    Point top;                   ///< map coordinates
    Point tip;
};

/// `bed` [m] is the sliding surface, `release` the vertical thickness of the failed mass [m] (positive: released),
/// `trace` a mask of the area reached, all on the same cells. Throws Error(input) if the cells differ or nothing is
/// released; a trace without cells gives zero length.
Runout runout(const Raster& bed, const Raster& release, const Raster& trace);

}  // namespace frana
