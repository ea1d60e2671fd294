// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid_spec.h"

namespace frana::sample {

/// Returns the height of the ground before the failure [m] at local metres from the south-western corner: a hillside of
/// 28 degrees on the north side, with gullies, a river flowing to the east at its foot, the other bank rising. It
/// contains the release.
double bindo_height(Point local);

/// Returns the northing of the river's middle at an easting, local metres.
double river_line(double x);

}  // namespace frana::sample
