// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana::render {

/// A line of equal value in map coordinates; closed if its last point is its first.
struct Contour {
    double level = 0;
    Polyline points;
};

/// Returns lines of equal value between cell centres at the multiples of `interval`, joined as far as possible.
std::vector<Contour> contour_lines(const Raster& raster, double interval);

}  // namespace frana::render
