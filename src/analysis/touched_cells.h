// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"
#include "core/grid_spec.h"

namespace frana {

/// Returns the cells of a grid that a feature touches, each once, in order: of an area those of which it covers a
/// part, however small, of a line those through which it runs, of a point the one that it lies in. An area that only
/// borders on a cell does not touch it; a line along the border of two cells, and a point on it, belong to the eastern
/// or southern one. Exact but for the rounding of coordinates.
std::vector<std::size_t> touched_cells(const MixedShape& shape, const GridSpec& grid);

/// Where a feature lies.
enum class MapPlace { inside, partly, outside };

MapPlace place_of(const MixedShape& shape, const Bounds& map);

}  // namespace frana
