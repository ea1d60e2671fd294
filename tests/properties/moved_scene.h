// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scene.h"

namespace frana::test {

/// Returns the mirrored scene: east becomes west.
Scene mirrored(const Scene& scene);
Raster mirrored(const Raster& raster);

/// Returns the scene turned about its south-western corner by quarters, counter-clockwise, on a plain grid: cells are
/// reordered, so that except for rounding nothing may change.
Scene turned(const Scene& scene, int quarters);
Raster quarter_turned(const Raster& raster);

/// Returns the scene at another place: the given number of cells to the east and to the north.
Scene moved(const Scene& scene, std::int64_t east, std::int64_t north);

/// Returns the scene on a larger terrain: with further cells on each side, where the ground continues at the height of
/// the edge minus `drop` per cell.
Scene widened(const Scene& scene, std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north,
              double drop);
/// Returns the part of a widened scene's raster on the original grid.
Raster narrowed(const Raster& raster, const GridSpec& grid);

}  // namespace frana::test
