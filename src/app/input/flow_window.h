// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "app/text/run_log.h"
#include "gis/raster/raster_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// The part of a large DTM that a scene needs, in the working CRS: release and inflow, the layers that must lie on
/// it, and all ground under the energy line. A mass on a bed of friction mu loses mu metres of height for each metre
/// on the map (Heim 1932), so nothing it reaches lies above z + v^2 / 2g - mu * distance, with z the top of the mass
/// and v its speed where it starts; mu is taken a fifth smaller, to be on the safe side, and less what pore pressure
/// takes off. None where the whole DTM is needed: no friction, one that differs by place or that no law of the bed
/// resists with at least, or nothing that starts; and where more than `most_area` [m2] would be needed, of which then
/// no more is looked at than that takes.
std::optional<Bounds> flow_window(const SceneReading& reading, const gis::RasterInfo& dtm,
                                  const std::string& working_crs,
                                  double most_area = std::numeric_limits<double>::infinity());

/// The smallest rectangle around two.
Bounds united(const Bounds& a, const Bounds& b);

}  // namespace frana::app
