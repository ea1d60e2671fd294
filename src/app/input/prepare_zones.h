// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "simulation/scene.h"

namespace frana::app {

/// Reads what [zones] and terrain.friction-zones say onto the working grid: polygons by their cells' centres,
/// the later feature where two overlap, then rasters. Reports overlaps, gaps inside the zones and what share
/// of the grid keeps the material's own value. Adds every problem to `problems`; without a ground (null) files
/// are only checked. Adds what was read to `files`.
MaterialZones prepare_zones(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files,
                            RunLog& log, Problems& problems);

/// A raster of values of `key` on the working grid, checked against the key's limits; none, with a problem
/// told or without a ground, where it cannot be had. `elsewhere` says what holds where it has no value;
/// empty: not worth a word.
std::optional<Raster> read_zone_raster(const SceneReading& reading, const TerrainInput* ground, const std::string& key,
                                       const std::string& file, const std::string& elsewhere,
                                       std::vector<UsedFile>& files, RunLog& log, Problems& problems);

/// Zones of something that the scene's laws never read are a mistake: told as problems.
void refuse_unused_zones(const SceneReading& reading, const Scene& scene, Problems& problems);

}  // namespace frana::app
