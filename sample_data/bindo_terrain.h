// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid_spec.h"

namespace frana::sample {

/// Height of the ground before the failure [m] at local metres from the south-western corner: a hillside of
/// 28 degrees on the north side, furrowed by gullies, a river flowing to the east at its foot, the other bank
/// rising. It contains the mass that fails.
double bindo_height(Point local);

/// Northing of the river's middle at an easting, local metres.
double river_line(double x);

}  // namespace frana::sample
