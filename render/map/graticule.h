// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/map_body.h"

namespace frana::render {

/// Width of the band beside the frame that ticks and their labels take [px].
double tick_band(const PageStyle& style);

/// "9°24′30″ E", "0.5″" and finer for steps under a second; `letters` are those of the positive and the negative
/// side: "EW", "NS".
std::string degree_words(double degrees, double step, const std::string& letters);

/// Places along a side at which a smooth, rising or falling coordinate takes round values; `at` gives it for a place
/// from 0 to 1. Values beyond a full turn are not expected.
struct RoundPlace {
    double value = 0, place = 0;
};
std::vector<RoundPlace> round_places(const std::function<double(double)>& at, double step);

/// Longitudes along the upper and latitudes along the right side of the frame: ticks and labels at round degrees,
/// minutes or seconds, where the projection puts them. Nothing where the window has no longitude.
void draw_graticule(Sheet& sheet, const PageStyle& style, const MapFrame& frame,
                    const std::function<Point(Point)>& longitude_latitude);

}  // namespace frana::render
