// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "core/raster.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Looks at the ground that a run will use. Throws Error(input) at elevations that no unit makes ground;
/// warns of what is higher or lower than any ground, of slopes that are a mistaken unit, and of single cells
/// off all their neighbours, with their places.
void check_terrain(const SceneReading& reading, const Raster& terrain, RunLog& log);

}  // namespace frana::app
