// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gis/raster/raster_in.h"

namespace frana::gis {

/// One elevation [m] at a place in the target CRS.
struct ElevationSample {
    Point place;
    double elevation = 0;
};

/// Returns a regular sample of at most most_per_side squared cells of a raster (interpreted in dtm.crs_wkt) inside
/// `window` (target CRS): fast for any size of file, and only an overview of the ground. Cells without data are
/// omitted. `vertical_unit`, `nodata_value` as in read_raster_on. Throws Error(input).
std::vector<ElevationSample> sample_elevations(const RasterInfo& dtm, const std::string& target_crs_wkt,
                                               const Bounds& window, int most_per_side,
                                               const std::string& vertical_unit, std::optional<double> nodata_value);

}  // namespace frana::gis
