// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/text/run_log.h"
#include "gis/raster/raster_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// The working CRS (WKT): what terrain.crs asks for, else the DTM's own if that is projected, in metres and
/// true to scale, else the UTM zone of the DTM's centre. Empty: local. Throws Error(input) with the remedy
/// where there is none, or where lengths in the one asked for are not lengths on the ground.
std::string choose_working_crs(const SceneReading& reading, const gis::RasterInfo& dtm, RunLog& log);

}  // namespace frana::app
