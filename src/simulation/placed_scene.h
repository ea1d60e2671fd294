// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scene.h"

namespace frana {

/// How a grid lies against the ground of a scene, compared with the scene's own.
struct GridPlacement {
    double shift = 0;     ///< to the east and to the north, 0 to 1 [cells]
    double turn_deg = 0;  ///< of the ground in the grid's axes, counter-clockwise
};

/// A scene on another grid.
struct PlacedScene {
    Scene scene;    ///< in plain metres from the new grid's south-western corner; records nothing by the way
    Raster inside;  ///< on its grid: 1 on the scene's ground, 0 beyond it; empty: all of it is
};

/// The same ground, release, zones and walls on a grid that lies otherwise, of cells as large.
///
/// By a multiple of 90 degrees cells are only put in another order, and outlines turned: nothing is
/// interpolated, and but for rounding nothing in the flow may change. Otherwise elevations are interpolated
/// by cubic convolution (Keys 1981) between the centres of the scene's cells, bilinearly where one of the
/// sixteen has none; depths bilinearly, each release area keeping its volume; zones and walls take the
/// nearest cell. A cell whose nearest has no elevation has none. Beyond the scene's edge the ground falls by
/// one cell a cell for five cells, so that what leaves does not come back, or is a wall where the scene has
/// walls for edges; it is not `inside`.
PlacedScene placed_otherwise(const Scene& scene, const GridPlacement& placement);

/// The cells of a raster turned by 90 degrees, counter-clockwise; its south-western corner stays.
Raster quarter_turned(const Raster& raster);

}  // namespace frana
