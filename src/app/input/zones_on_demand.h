// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"

namespace frana::app {

/// A value of the material on a large working grid, of which nothing exists until a cell is asked for: that of each
/// polygon in the cells whose centre is inside, the later one where two overlap; NaN elsewhere. `values` has one for
/// each of the features, or none.
Raster polygon_values_on_demand(const GridSpec& grid, const std::vector<PolygonFeature>& features,
                                const std::vector<std::optional<double>>& values);

/// The same from a raster of any kind. `convert` makes a value out of what the file has, or throws; not called for NaN.
Raster raster_values_on_demand(const GridSpec& grid, const std::shared_ptr<const gis::RasterOnDemand>& file,
                               const std::function<double(double)>& convert);

}  // namespace frana::app
