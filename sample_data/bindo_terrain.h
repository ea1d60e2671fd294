// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry.h"
#include "core/grid_spec.h"

namespace frana::sample {

/// Returns the grid: 1500 m x 1350 m at 5 m near Cortenova (9.38 E, 46.0 N); the writer sets the CRS.
GridSpec bindo_grid();

inline constexpr double k_release_volume = 1.2e6;  ///< [m3]
inline constexpr double k_release_thickest = 38;   ///< [m], vertical

/// Returns the distance from the release's middle relative to that of its edge in the same direction: 0 to 1 inside.
double release_radius(Point local);
/// Returns the vertical thickness of the release [m]: a bowl, thickest in the middle, 0 at the edge and beyond.
double release_thickness(Point local);
/// Returns the release's outline, counter-clockwise, in local metres: some 400 m long downslope and 200 m wide.
Ring release_rim();

/// Returns the surveyed outline, in local metres: drawn by hand, from no simulation.
Ring scar_outline();

/// Returns the height of the ground before the failure [m] at local metres from the south-western corner: a hillside of
/// 28 degrees on the north side, with gullies, a river flowing to the east at its foot, the other bank rising. It
/// contains the release.
double bindo_height(Point local);

/// Returns the northing of the river's middle at an easting, local metres.
double river_line(double x);

}  // namespace frana::sample
