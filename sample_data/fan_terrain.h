// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry.h"
#include "core/grid_spec.h"

namespace frana::sample {

/// Returns the grid: 1200 m x 1530 m at 5 m; the writer sets the CRS.
GridSpec fan_grid();

inline constexpr int k_fan_gullies = 2;

/// Returns the northing of the foot of the mountain side at an easting, local metres; the fan lies around it.
double fan_foot(double x);
/// Returns the easting of a gully's bed, 0 the western one, at a distance uphill of the foot, local metres. Below the
/// mouths it is that of the channel on the fan.
double gully_line(int gully, double distance);

/// Returns the height of the ground [m] at local metres from the south-western corner: a mountain side of 30 to 35
/// degrees with two gullies, which meet in one fan of 12 to 8 degrees, 400 m wide, above a valley floor.
double fan_height(Point local);

}  // namespace frana::sample
