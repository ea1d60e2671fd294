// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/run_log.h"
#include "gis/raster_in.h"
#include "params/read_scene.h"

namespace frana::app {

/// The part of a large DTM that a scene needs, in the working CRS: the release, the scar, and all ground
/// under the energy line. A mass on a bed of friction mu loses mu metres of height for each metre on the map
/// (Heim 1932), so nothing it reaches lies above z_release - mu * distance; mu is taken a quarter smaller, to
/// be on the safe side. None where the whole DTM is needed or the release is not known.
std::optional<Bounds> flow_window(const SceneReading& reading, const gis::RasterInfo& dtm,
                                  const std::string& working_crs);

}  // namespace frana::app
