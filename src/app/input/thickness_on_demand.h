// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "params/grammar/thickness.h"

namespace frana::app {

/// Thickness on a large working grid, of which nothing is read until a cell is asked for: that of the file, or the
/// positive part of before minus after or of the ground minus the slip surface. `files` are those of the key, in its
/// order; `ground` may be null where they are enough.
Raster thickness_on_demand(ThicknessSpec::Kind kind, const GridSpec& grid,
                           const std::vector<std::shared_ptr<const gis::RasterOnDemand>>& files,
                           const std::shared_ptr<const gis::RasterOnDemand>& ground);

/// Returns a mask of the cells of such a raster that are positive, by reading, part by part, the cells within `extent`
/// (map coordinates); only parts with such a cell remain in memory.
Raster positive_cells(const Raster& thickness, const Bounds& extent);
/// Returns the values of these cells; NaN elsewhere.
Raster positive_values(const Raster& thickness, const Bounds& extent);

}  // namespace frana::app
