// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/canvas/page.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"
#include "render/map/relief.h"

namespace frana::render {

/// Contour lines of a terrain in map coordinates.
struct Contours {
    double interval = 0;  ///< [m]; 0: there are none
    std::vector<Contour> lines{};
};
/// Returns those in a frame, as many as can be distinguished.
Contours find_contours(const MapFrame& frame, const Raster& terrain);

/// Draws contour lines; every fifth one is stronger and labelled where it is straight and its label covers neither a
/// value of `layer` (none: null) nor an outline.
void draw_contours(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const Contours& contours,
                   const Raster* layer, const std::vector<Outline>& outlines, const Words& words);

/// Draws outlines, each on a light rim to be visible on any colour.
void draw_outlines(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const std::vector<Outline>& outlines);

/// Draws the symbol of a place: a triangle on a light rim.
void draw_place(Sheet& sheet, const PageStyle& style, Point at, Rgb colour);

/// Draws coordinates: ticks and labels along the frame's lower and left side, of each the coordinate that varies more
/// along it; small crosses inside. The caller draws the frame itself. `projected`: eastings and northings, otherwise
/// plain metres.
void draw_coordinates(Sheet& sheet, const PageStyle& style, const MapFrame& frame, bool projected, const Words& words);

/// Width of the band beside the frame for ticks and their labels [px].
double tick_band(const PageStyle& style);

/// Returns "9°24′30″ E", "0.5″" and finer for steps below a second; `letters` are those of the positive and the
/// negative side: "EW", "NS".
std::string degree_words(double degrees, double step, const std::string& letters);

/// Positions along a side at which a smooth, monotonic coordinate has round values; `at` returns it for a position from
/// 0 to 1. Values beyond a full turn are not expected.
struct RoundPlace {
    double value = 0, place = 0;
};
std::vector<RoundPlace> round_places(const std::function<double(double)>& at, double step);

/// Draws longitudes along the upper and latitudes along the right side of the frame, on a map turned by more than 45
/// degrees the other way round: ticks and labels at round degrees, minutes or seconds, placed by the projection.
/// Nothing if the window has no longitude.
void draw_graticule(Sheet& sheet, const PageStyle& style, const MapFrame& frame,
                    const std::function<Point(Point)>& longitude_latitude, const Words& words);

}  // namespace frana::render
