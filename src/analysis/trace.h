// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"

namespace frana {

/// 1 where the depth exceeds the threshold [m], 0 elsewhere (no data included).
Raster trace_mask(const Raster& depth, double threshold);

/// Area of the cells that are neither 0 nor without data [m2].
double masked_area(const Raster& mask);

/// The largest value; NaN where there is none.
double maximum(const Raster& raster);

/// The raster on a grid of the same cells that also covers `box`; new cells have `fill`.
/// The raster itself where the box lies inside already.
Raster padded_to(const Raster& raster, const Bounds& box, double fill);

}  // namespace frana
