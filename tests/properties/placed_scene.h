// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scene.h"

namespace frana {

/// Position of a grid relative to the scene's own.
struct GridPlacement {
    double shift = 0;     ///< to the east and to the north, 0 to 1 [cells]
    double turn_deg = 0;  ///< of the ground in the grid's axes, counter-clockwise
};

/// A scene on another grid.
struct PlacedScene {
    Scene scene;    ///< in plain metres from the new grid's south-western corner; without intermediate recordings
    Raster inside;  ///< on its grid: 1 on the scene's ground, 0 beyond it; empty: 1 everywhere
};

/// Returns the same ground, release, zones and walls on a grid at another position, with cells of the same size.
///
/// By a multiple of 90 degrees cells are only reordered, and outlines turned: nothing is interpolated, and except for
/// rounding nothing in the flow may change. Otherwise elevations are interpolated by cubic convolution (Keys 1981)
/// between the centres of the scene's cells, bilinearly where one of the sixteen has none; depths bilinearly, each
/// release area keeping its volume; zones and walls take the nearest cell. A cell whose nearest has no elevation has
/// none. Beyond the scene's edge the ground falls by one cell per cell for five cells, so that material that leaves
/// does not return, or is a wall if the scene's edges are walls; it is not `inside`.
PlacedScene placed_otherwise(const Scene& scene, const GridPlacement& placement);

/// Sets the origin to a corner of cells, or as place_origin where no cell begins there: the stress of solids acts
/// through a lattice that begins at the origin, whatever the cells are. It is the same lattice in a scene that was
/// turned or mirrored if its origin is where the original's came to lie.
void place_origin_at(Scene& scene, OriginCell corner);

/// Returns a raster with its cells turned by 90 degrees, counter-clockwise, about its south-western corner.
Raster quarter_turned(const Raster& raster);

}  // namespace frana
