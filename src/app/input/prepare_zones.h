// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/friction_table.h"
#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "simulation/scene.h"

namespace frana::app {

/// Reads [zones] and terrain.friction-zones onto the working grid: polygons by their cells' centres, the later feature
/// where two overlap, then rasters. Reports overlaps, gaps inside the zones and the fraction of the grid with the
/// material's own value. Where the ground is read where the flow comes, so are they, and only what lies under
/// `released` (map coordinates) is looked at now. Adds every problem to `problems`; without terrain (null) files are
/// only checked. Adds the files read to `files`.
MaterialZones prepare_zones(const SceneReading& reading, const TerrainInput* ground, const MultiPolygon& released,
                            std::vector<UsedFile>& files, Findings found, Problems& problems);

/// Reads material.forest: 1 where forest stands, NaN elsewhere; none without the key. Of a raster nothing is stored
/// until a cell is asked for.
std::optional<Raster> prepare_forest(const SceneReading& reading, const TerrainInput* ground,
                                     std::vector<UsedFile>& files, Findings found, Problems& problems);

/// Returns "< 1 000 m", "1 000 – 1 500 m", "≥ 1 500 m", or "all" without limits.
Sentence class_text(const std::vector<double>& limits, std::size_t at, const std::string& unit);
/// Returns the table, by what it is read, and its source.
Sentence friction_text(const FrictionChoice& choice);

/// Returns a raster of values of `key` on the working grid, checked against the key's limits; none, with a problem
/// added or without terrain, if it cannot be read.
/// @param tell_gaps warns of cells without a value
std::optional<Raster> read_zone_raster(const SceneReading& reading, const TerrainInput* ground, const std::string& key,
                                       const std::string& file, bool tell_gaps, std::vector<UsedFile>& files,
                                       Findings found, Problems& problems);

/// Adds problems for zones of quantities that the scene's laws do not read.
void refuse_unused_zones(const SceneReading& reading, const Scene& scene, Problems& problems);

}  // namespace frana::app
