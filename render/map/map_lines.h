// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/canvas/page.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"

namespace frana::render {

/// Draws contour lines of a terrain; every fifth one is stronger and labelled where it is straight and its label covers
/// neither a value of `layer` nor an outline. Returns the interval in metres; 0 if there is nothing to draw.
double draw_contours(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const Raster& terrain,
                     const Raster* layer, const std::vector<Outline>& outlines, const Words& words);

/// Draws outlines, each on a light rim to be visible on any colour.
void draw_outlines(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const std::vector<Outline>& outlines);

/// Draws the symbol of a place: a triangle on a light rim.
void draw_place(Sheet& sheet, const PageStyle& style, Point at, Rgb colour);

/// Draws coordinates: ticks and labels along the frame's lower and left side, small crosses inside. The caller draws
/// the frame itself. `projected`: eastings and northings, otherwise plain metres.
void draw_coordinates(Sheet& sheet, const PageStyle& style, const MapFrame& frame, bool projected, const Words& words);

}  // namespace frana::render
