// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"

namespace frana::app {

/// Reads built structures: raises the ground by terrain.obstacles, and returns 1 where terrain.walls are, on the
/// working grid (none without walls). Adds every problem to `problems`; without terrain (null) files are only checked.
/// Adds the files read to `files`.
std::optional<Raster> prepare_obstacles(const SceneReading& reading, TerrainInput* ground, std::vector<UsedFile>& files,
                                        RunLog& log, Problems& problems);

}  // namespace frana::app
