// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scene.h"

namespace frana::test {

/// The scene as a mirror sees it: east becomes west.
Scene mirrored(const Scene& scene);
Raster mirrored(const Raster& raster);

/// The scene elsewhere: so many cells to the east and to the north.
Scene moved(const Scene& scene, std::int64_t east, std::int64_t north);

/// The scene on a larger terrain: so many more cells on each side, where the ground goes on at the height of the edge
/// less `drop` a cell.
Scene widened(const Scene& scene, std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north,
              double drop);
/// The part of a widened scene's raster that the first scene had.
Raster narrowed(const Raster& raster, const GridSpec& grid);

}  // namespace frana::test
