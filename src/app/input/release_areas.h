// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/input/prepare_terrain.h"
#include "gis/vector/vector_in.h"
#include "simulation/scene.h"

namespace frana::app {

/// Sets name, start, velocity, direction and volume of an area: the scene's numbers, or a feature's own in the columns
/// named by the keys (null layer: numbers only).
void set_details(const SceneReading& reading, const gis::PolygonLayer* layer, std::size_t feature, ReleaseArea& area,
                 Problems& problems);

/// Returns one area per feature, its thickness the scene's number or the feature's own attribute.
std::vector<ReleaseArea> areas_by_feature(const SceneReading& reading, const gis::PolygonLayer& layer,
                                          Problems& problems);

/// Returns one area per feature with the same thickness raster; one for all if features overlap, so that common area
/// counts once (then without attributes of their own: that is a problem).
std::vector<ReleaseArea> areas_of_raster(const SceneReading& reading, const gis::PolygonLayer& layer,
                                         const Raster& thickness, Problems& problems);

/// Returns one area per feature, down to a slip surface fitted to it: of the depth release.slip-depth, or of the depth
/// that gives release.volume; a volume for several polygons is divided over similar surfaces, their depths proportional
/// to the square roots of their areas. Logs shape and depth of each.
std::vector<ReleaseArea> areas_above_slip_surfaces(const SceneReading& reading, const gis::PolygonLayer& layer,
                                                   const Raster& ground, RunLog& log, Problems& problems);

}  // namespace frana::app
