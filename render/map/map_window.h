// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/map/map2d.h"

namespace frana::render {

/// Returns the grid with the CRS of a map.
const GridSpec& map_grid(const MapSpec& spec);

/// Returns what a map must show: the requested window, else the flow and the outlines, else the whole terrain.
Bounds required_window(const MapSpec& spec);

/// Returns the ground shown in a frame of width x height pixels: what the map must show, with a margin and at the scale
/// of its print (window_at_scale); within the terrain as far as possible. Throws as window_at_scale.
Bounds map_window(const MapSpec& spec, int width, int height);

}  // namespace frana::render
