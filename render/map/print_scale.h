// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/map/map2d.h"

namespace frana::render {

/// Metres of ground under a pixel of a page at 1 : n.
double metres_per_pixel(double n, double dots_per_inch);
/// The inverse: n.
double scale_of(double metres_per_pixel, double dots_per_inch);
/// Returns the least usual scale of maps that is at least `n`: 500, 1000, 2000, 2500, 5000, 10 000, 20 000, 25 000 and
/// so on.
double round_scale_above(double n);

/// Returns the ground shown in a frame of width x height pixels. `required`: must be visible; `free`: the same with a
/// margin, and the frame's proportions. With print.scale: that scale, centred; without, on a sheet: the least round
/// scale at which the content fits, if the map shrinks to no less than 2/3 of `free` (a longer side of 90 mm becomes
/// at least 60 mm); else `free`. Throws Error(input) if the content does not fit at print.scale.
Bounds window_at_scale(const Print& print, const Bounds& required, const Bounds& free, int width, int height);

/// The least n at which `required` fits.
double least_scale(const Print& print, const Bounds& required, int width, int height);

/// Returns "1 : 5 000".
std::string scale_words(double n, const Words& words = {});
/// Returns what the scale refers to: "on A4", "printed 27.1 x 20.3 cm".
std::string print_words(const Print& print, double page_width, double page_height, const Words& words = {});

}  // namespace frana::render
