// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/input/prepare_terrain.h"
#include "gis/vector/vector_in.h"

namespace frana::app {

/// The working CRS; geographic coordinates stand in where the ground is not known, so that a file is still
/// checked.
std::string target_crs(const SceneReading& reading, const TerrainInput* ground);

/// The value of `key` for one feature of a layer: the scene's number, or the feature's in the column it names,
/// checked against the key's limits. None, with a problem told, where there is no such number.
std::optional<double> value_of(const SceneReading& reading, const std::string& key, const SourceSpec& source,
                               const gis::PolygonLayer& layer, std::size_t feature, Problems& problems);

/// Whether a number is within the limits of a key; tells a problem where it is not. `what` names its bearer.
bool within_limits(const SceneReading& reading, const std::string& key, double value, const std::string& what,
                   Problems& problems);

/// Tells a problem where a layer lies outside the working grid or, unless `may_reach_beyond`, reaches over its
/// edge.
bool is_on_ground(const SceneReading& reading, const std::string& key, const Bounds& box, const TerrainInput& ground,
                  bool may_reach_beyond, Problems& problems);

}  // namespace frana::app
