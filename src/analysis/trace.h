// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana {

/// Returns the outlines, along the edges of cells, of the areas where values are positive; NaN is not. Cells that share
/// an edge are one area; each area is a polygon with its holes.
/// @param values one per cell of the grid, row by row from the north
MultiPolygon outlines_where_positive(const GridSpec& grid, std::span<const double> values);

/// Returns 1 where the depth exceeds the threshold [m], 0 elsewhere (including no data).
Raster trace_mask(const Raster& depth, double threshold);

/// Returns for each cell the distance to the line between the cells of an area and all others, in cells: positive
/// inside, negative outside, from the middle of the cell to that of the nearest on the other side less a half. Where
/// there is no other side the diagonal of the map takes its place.
/// @param inside by row and column, 1 in the area, 0 elsewhere
std::vector<double> distances_from_rim(const std::vector<char>& inside, std::size_t columns);

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
