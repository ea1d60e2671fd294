// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "core/raster.h"
#include "gis/vector/exposed_in.h"

namespace frana::app {

/// Warns of exposed features of which the map will say nothing: off the map, without geometry, or where the terrain has
/// no elevation.
/// @param map the ground that is computed
/// @param terrain null, or in tiles: not looked at
void warn_of_unknown_exposure(const gis::ExposedLayer& layer, const Bounds& map, const Raster* terrain, RunLog& log);

}  // namespace frana::app
