// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/raster.h"

namespace frana::render {

/// Returns shaded relief lit from several directions around the north-west, so that slopes parallel to the light remain
/// visible: 0 dark to 1 bright on the terrain's own grid, NaN where the terrain has no value.
Raster hillshade(const Raster& terrain);

/// A line of equal value in map coordinates; closed if its last point is its first.
struct Contour {
    double level = 0;
    Polyline points;
};

/// Returns lines of equal value between cell centres at the multiples of `interval`, found by VTK; a line that is not
/// closed may be in parts. Throws Error(environment) if VTK is missing.
std::vector<Contour> contour_lines(const Raster& raster, double interval);

}  // namespace frana::render
