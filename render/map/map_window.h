// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/map/map2d.h"

namespace frana::render {

/// The grid that says in which CRS a map is.
const GridSpec& map_grid(const MapSpec& spec);

/// What the frame shows, with the frame's own width over height: the window asked for, else the flow and the
/// outlines with a margin, else the whole terrain; kept on the terrain as far as that is possible.
Bounds map_window(const MapSpec& spec, double aspect);

}  // namespace frana::render
