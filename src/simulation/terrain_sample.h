// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"
#include "simulation/scene.h"

namespace frana {

/// A cell of a raster.
struct Cell {
    std::int64_t row, column;
};

/// Returns the cell that contains a local point, the nearest one for points outside.
Cell cell_of(const GridSpec& grid, Point local);

/// Returns the slope of the terrain at a cell (east, north) [-], from the neighbours that have data.
Point gradient(const Raster& terrain, Cell cell);

/// Returns the map-view fraction of a speed along the bed in a direction (a unit vector): 1 / sqrt(1 + climb^2), or 1
/// if the scene's equations do not distinguish them.
double map_fraction(const Numerics& numerics, Point slope, Point direction);

}  // namespace frana
