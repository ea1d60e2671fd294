// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "gis/crs/crs.h"
#include "support/files.h"

namespace frana::gis::test {

inline constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

inline GridSpec utm_grid(double west, double north, double cell, int columns, int rows) {
    return {west, north, cell, columns, rows, crs_from_user("EPSG:32632", "")};
}

/// An inclined plane: z = 1000 + 0.3 (x - west) + 0.2 (y - north), which every consistent resampling reproduces.
inline double plane(double x, double y) {
    return 1000 + 0.3 * (x - 527000) + 0.2 * (y - 5095000);
}

inline TestRaster plane_raster(int columns, int rows, double cell) {
    TestRaster raster{columns, rows, 527000, 5095000, cell, cell, "EPSG:32632", {}, std::nullopt, "", 1, 0, 0, false};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            raster.values.push_back(plane(527000 + (column + 0.5) * cell, 5095000 - (row + 0.5) * cell));
        }
    }
    return raster;
}

}  // namespace frana::gis::test
