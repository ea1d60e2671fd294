// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/grid_spec.h"

namespace frana::gis {

/// Metres on the map per metre on the ellipsoid, the least and the greatest over all directions at one place.
struct MapScale {
    double least = 1, greatest = 1;

    /// Relative error of lengths on the map.
    [[nodiscard]] double error() const noexcept;
};

/// Returns the scale of a projected CRS in metres at a place in its coordinates; 1 for "" (local). Measured with
/// geodesics (Karney 2013, doi 10.1007/s00190-012-0578-z) along four directions. Throws Error(input) if the projection
/// has no inverse.
MapScale map_scale(const std::string& wkt, Point map);

}  // namespace frana::gis
