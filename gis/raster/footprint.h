// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana::gis {

/// Returns 1 in cells whose centre is inside, 0 elsewhere. Holes are outside.
Raster coverage(const MultiPolygon& polygons, const GridSpec& grid);

/// Returns outlines along cell edges of all cells that are neither 0 nor NaN, with holes; cells that touch only at a
/// corner belong to different polygons.
MultiPolygon polygonise(const Raster& mask);

/// Which cells a polygon covers.
enum class Cover {
    centres,  ///< those whose centre is inside
    closed,   ///< the same; where the polygon is narrower than a cell's diagonal, all cells that it touches, so that a
              ///< thin dam has no gaps
};

/// Calls visit(row, column) once for each cell of an outline, row by row; parts beyond the grid are ignored. Returns
/// whether touched cells were included because the outline is narrow.
bool visit_cells(const MultiPolygon& outline, const GridSpec& grid, Cover cover,
                 const std::function<void(std::int64_t row, std::int64_t column)>& visit);

}  // namespace frana::gis
