// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/text/run_log.h"
#include "gis/raster/raster_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Returns the working CRS (WKT): that of terrain.crs, else the DTM's own if projected, in metres and true to scale,
/// else the UTM zone of the DTM's centre. Empty: local. Throws Error(input) with the remedy if there is none, or if
/// lengths in the requested one are not lengths on the ground.
std::string choose_working_crs(const SceneReading& reading, const gis::RasterInfo& dtm, RunLog& log);

}  // namespace frana::app
