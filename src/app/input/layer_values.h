// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/input/prepare_terrain.h"
#include "gis/vector/vector_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Returns the choice of the keys KEY-layer, KEY-filter and KEY-crs. Throws Error(input) for an unknown CRS.
gis::LayerChoice layer_choice(const SceneReading& reading, const LayerSpec& spec, const std::string& key);

/// "feature 3 of slopes".
std::string feature_name(const gis::PolygonLayer& layer, std::size_t feature);

/// Returns the working CRS; geographic coordinates if the terrain is missing, so that a file is still checked.
std::string target_crs(const SceneReading& reading, const TerrainInput* ground);

/// Returns the value of `key` for one feature of a vector layer: the scene's number, or the feature's value in the
/// column named by the key, checked against the key's limits. None, with a problem added, if there is no such number.
std::optional<double> value_of(const SceneReading& reading, const std::string& key, const SourceSpec& source,
                               const gis::PolygonLayer& layer, std::size_t feature, Problems& problems);

/// Returns whether a number is within the limits of a key; adds a problem if not. `what` names its feature.
bool within_limits(const SceneReading& reading, const std::string& key, double value, const std::string& what,
                   Problems& problems);

/// Adds a problem if a vector layer is outside the working grid or, unless `may_reach_beyond`, crosses its edge.
bool is_on_ground(const SceneReading& reading, const std::string& key, const Bounds& box, const TerrainInput& ground,
                  bool may_reach_beyond, Problems& problems);

}  // namespace frana::app
