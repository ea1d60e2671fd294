// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"
#include "simulation/scene.h"

namespace frana {

/// A cell of a raster.
struct Cell {
    std::int64_t row, column;
};

/// The cell that holds a local point, the nearest one for points outside.
Cell cell_of(const GridSpec& grid, Point local);

/// Slope of the terrain at a cell (east, north) [-], from the neighbours that have data.
Point gradient(const Raster& terrain, Cell cell);

/// Map-view fraction of a speed along the bed in a direction (a unit vector): 1 / sqrt(1 + climb^2), or 1 where
/// the scene's equations do not know the difference.
double map_fraction(const Numerics& numerics, Point slope, Point direction);

}  // namespace frana
