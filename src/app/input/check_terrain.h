// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "core/raster.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Checks the terrain of a run. Throws Error(input) for elevations impossible in any unit; warns of elevations above or
/// below any ground, of slopes that indicate a wrong unit, and of single cells far from all their neighbours, with
/// their places.
void check_terrain(const SceneReading& reading, const Raster& terrain, RunLog& log);

}  // namespace frana::app
