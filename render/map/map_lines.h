// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"

namespace frana::render {

/// Contour lines of a terrain with every fifth one stronger and labelled where it runs straight and its label
/// covers neither a value of `layer` nor an outline. Returns the interval in metres; 0 where there is nothing
/// to draw.
double draw_contours(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const Raster& terrain,
                     const Raster* layer, const std::vector<Outline>& outlines);

/// Outlines, each on a light rim so that they show on any colour.
void draw_outlines(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const std::vector<Outline>& outlines);

/// The sign of a place: a triangle on a light rim.
void draw_place(Canvas& canvas, const PageStyle& style, Point at, Rgb colour);

/// The names of places, beside them where there is room; to be called before the contours, whose labels keep off.
void draw_place_names(Sheet& sheet, const PageStyle& style, const MapFrame& frame,
                      const std::vector<Outline>& outlines);

/// Coordinates: ticks and labels along the frame's lower and left side, small crosses inside. The frame
/// itself is drawn by the caller. `projected`: eastings and northings, otherwise plain metres.
void draw_coordinates(Sheet& sheet, const PageStyle& style, const MapFrame& frame, bool projected);

}  // namespace frana::render
