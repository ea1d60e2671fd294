// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/raster.h"
#include "params/keys/result_rasters.h"
#include "simulation/result.h"

namespace frana::app {

/// What a run holds of a row of the table; null where it has none, or others make it (classes, the terrain).
const Raster* find_raster(const RunResult& result, const ResultRaster& row);

/// Those that every run has of its flow.
std::vector<ResultRaster> main_rasters();

/// Class bounds of a legend, the same in the GIS style and on the maps. `maximum` may be NaN (nothing flowed).
/// @param progressive as in ResultRaster
std::vector<double> class_bounds(bool progressive, double maximum);

}  // namespace frana::app
