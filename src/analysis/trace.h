// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// Returns the outlines, along the edges of cells, of the areas where values are positive; NaN is not. Cells that share
/// an edge are one area; each area is a polygon with its holes.
/// @param values one per cell of the grid, row by row from the north
MultiPolygon outlines_where_positive(const GridSpec& grid, std::span<const double> values);

/// Returns 1 where the depth exceeds the threshold [m], 0 elsewhere (including no data).
Raster trace_mask(const Raster& depth, double threshold);

/// Returns the area of the cells that are neither 0 nor without data [m2].
double masked_area(const Raster& mask);

/// Returns the largest value; NaN if there is none.
double maximum(const Raster& raster);

/// Returns the raster on a grid of the same cells that also covers `box`; new cells have `fill`. The raster itself if
/// the box is inside already.
Raster padded_to(const Raster& raster, const Bounds& box, double fill);

/// Returns a window of a raster; of a window too large to be stored whole, what is stored of the raster there. An empty
/// raster remains empty.
Raster cut_to(const Raster& raster, const CellWindow& window);

}  // namespace frana
