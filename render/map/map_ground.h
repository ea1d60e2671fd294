// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "render/canvas/page.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"

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

/// The parts of a map below and above its raster that do not depend on it: relief or picture, contour lines, outlines,
/// frame and coordinates. Drawing them is most of a map's work.
struct MapGround {
    /// Parameters for which it was drawn.
    int width = 0, height = 0;
    double density = 1;
    int least_letters = k_least_letters;
    MapFrame frame;
    const Raster* terrain = nullptr;
    const Raster* kept_clear = nullptr;  ///< of contours' labels
    std::vector<Outline> outlines;

    Image face;     ///< the relief inside the frame
    Overlay above;  ///< lines and texts, white outside the frame
    std::vector<TextBox> texts;
    double contour_interval = 0;  ///< [m]; 0: no contours
    Language language = Language::english;
};

/// Returns `kept` if it was drawn for the same frame, terrain and outlines, else a new one, which is then kept.
const MapGround& ground_for(const MapSpec& spec, const MapFrame& frame, double density,
                            std::shared_ptr<const MapGround>& kept);

}  // namespace frana::render
