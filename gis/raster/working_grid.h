// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/grid_spec.h"
#include "gis/raster/raster_in.h"

namespace frana::gis {

/// Returns the grid to compute on: the DTM's own cells if CRS and cell size are its own; else edges on multiples of the
/// cell size. `bounds` (working CRS) are clipped to the DTM's and widened to whole cells. Default cell size: the DTM's
/// own if in metres (the smaller side if not square), else its resolution on the ground to 2 significant digits.
/// `dtm.crs_wkt` must already include any override; an empty `working_crs_wkt` means local. Throws Error(input) if the
/// bounds miss the DTM (both extents named) or the grid would be too large.
GridSpec working_grid(const RasterInfo& dtm, const std::string& working_crs_wkt, std::optional<Bounds> bounds,
                      std::optional<double> cell_size);

}  // namespace frana::gis
