// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/raster.h"
#include "params/keys/classes.h"
#include "params/keys/result_rasters.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns a run's raster of a row of the table; null if it has none, or another part makes it (classes, the terrain).
const Raster* find_raster(const RunResult& result, const ResultRaster& row);

/// Returns the rasters that every run produces from the flow.
std::vector<ResultRaster> main_rasters();

/// Returns class bounds of a legend, the same in the GIS style and on the maps: those of the row, else the fixed ones
/// of its quantity (the last is infinite), else or by choice round ones up to `maximum`, which may be NaN (nothing
/// flowed).
std::vector<double> class_bounds(const ResultRaster& row, const ClassSpec& chosen, double maximum);
/// The last: round ones up to the maximum.
std::vector<double> class_bounds(bool progressive, double maximum);

}  // namespace frana::app
