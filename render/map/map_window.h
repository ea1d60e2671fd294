// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/map/map2d.h"

namespace frana::render {

/// Returns the grid with the CRS of a map.
const GridSpec& map_grid(const MapSpec& spec);

/// Returns the extent of the frame, with the frame's width over height: the requested window, else the flow and the
/// outlines with a margin, else the whole terrain; within the terrain as far as possible.
Bounds map_window(const MapSpec& spec, double aspect);

}  // namespace frana::render
