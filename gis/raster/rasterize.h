// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry.h"
#include "core/raster.h"

namespace frana::gis {

/// Returns 1 in cells whose centre is inside, 0 elsewhere. Holes are outside.
Raster coverage(const MultiPolygon& polygons, const GridSpec& grid);

/// Returns outlines along cell edges of all cells that are neither 0 nor NaN, with holes; cells that touch only at a
/// corner belong to different polygons.
MultiPolygon polygonise(const Raster& mask);

}  // namespace frana::gis
