// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "render/canvas/page.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"
#include "render/map/map_lines.h"

namespace frana::render {

/// Returns what a map must show, in coordinates of the page (MapTurn): the requested window, else the flow and the
/// outlines, else the whole terrain.
Bounds required_window(const MapSpec& spec);

/// Returns the ground shown in a frame of width x height pixels: what the map must show, with a margin and at the scale
/// of its print (window_at_scale); within the terrain as far as possible. Throws as window_at_scale.
Bounds map_window(const MapSpec& spec, int width, int height);

/// Takes from a frame with such a window what lies beyond the terrain: there is nothing to show. Its upper left corner
/// and its scale stay.
void keep_to_ground(const MapSpec& spec, MapFrame& frame);

/// The parts of a map that are the same for all rasters in one frame. Making them is most of a map's work.
struct MapGround {
    MapFrame frame;
    const Raster* terrain = nullptr;
    Image face;  ///< relief or picture inside the frame
    Contours contours;
};

/// Returns `kept` if it was made for the same frame and terrain, else a new one, which is then kept.
const MapGround& ground_for(const MapSpec& spec, const MapFrame& frame, std::shared_ptr<const MapGround>& kept);

/// Draws what is over a map's raster: contour lines, outlines, names, white outside the frame, coordinates.
void draw_lines(Sheet& sheet, const PageStyle& style, const MapSpec& spec, const MapGround& ground);

}  // namespace frana::render
