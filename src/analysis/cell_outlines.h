// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/geometry.h"

namespace frana {

/// Returns the outlines, along the edges of cells, of the areas where values are positive; NaN is not. Cells that share
/// an edge are one area; each area is a polygon with its holes.
/// @param values one per cell of the grid, row by row from the north
MultiPolygon outlines_where_positive(const GridSpec& grid, std::span<const double> values);

}  // namespace frana
