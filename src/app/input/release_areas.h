// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/input/prepare_terrain.h"
#include "gis/vector/vector_in.h"
#include "simulation/scene.h"

namespace frana::app {

/// Start, velocity, direction and volume of an area: the scene's numbers, or a feature's own in the columns that the
/// keys name (null layer: numbers only).
void set_details(const SceneReading& reading, const gis::PolygonLayer* layer, std::size_t feature, ReleaseArea& area,
                 Problems& problems);

/// One area per feature, its thickness the scene's number or the feature's own attribute.
std::vector<ReleaseArea> areas_by_feature(const SceneReading& reading, const gis::PolygonLayer& layer,
                                          Problems& problems);

/// One area per feature with the same thickness raster; one for all where features overlap, so that ground counts
/// once (then without attributes of their own: that is a problem).
std::vector<ReleaseArea> areas_of_raster(const SceneReading& reading, const gis::PolygonLayer& layer,
                                         const Raster& thickness, Problems& problems);

/// One area per feature, down to a slip surface fitted to it: as deep as release.slip-depth says, or so deep that
/// release.volume is met; a volume for several polygons is shared out by similar surfaces, their depths as the
/// square roots of their areas. The log says shape and depth of each.
std::vector<ReleaseArea> areas_above_slip_surfaces(const SceneReading& reading, const gis::PolygonLayer& layer,
                                                   const Raster& ground, RunLog& log, Problems& problems);

}  // namespace frana::app
