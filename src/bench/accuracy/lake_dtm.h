// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/accuracy/accuracy_case.h"

namespace frana::bench {

/// The sample's terrain flooded to a level, without any forcing for 60 s: a lake with islands and a shoreline, on
/// ground rougher than the grid, since a coarse grid samples single elevations of the fine one instead of means. Walls
/// on all sides, no friction. Mark: no particle faster than 1e-4 m/s.
/// @param dtm elevations without gaps; its cell size is the finest level, the others skip cells
AccuracyCase lake_dtm(const Raster& dtm);

}  // namespace frana::bench
