// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "core/raster.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Checks the terrain of a run, or a part or samples of it; places are given in cells of `grid`. Throws Error(input)
/// for elevations impossible in any unit; warns of elevations above or below any ground, of slopes that indicate a
/// wrong unit, and of single cells far from all their neighbours, with their places.
void check_terrain(const SceneReading& reading, const Raster& terrain, const GridSpec& grid, RunLog& log);

}  // namespace frana::app
