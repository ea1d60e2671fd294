// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "params/keys/result_rasters.h"
#include "simulation/result.h"

namespace frana {

/// Returns a run's raster of a row of the table; null if it has none, or another part makes it (classes, the terrain).
const Raster* raster_of_row(const RunResult& result, const ResultRaster& row);

}  // namespace frana
