// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/page.h"
#include "render/map/colour_scale.h"
#include "render/map/map2d.h"

namespace frana::render {

/// Metres of ground under a pixel of a page at 1 : n.
double metres_per_pixel(double n, double dots_per_inch);
/// The inverse: n.
double scale_of(double metres_per_pixel, double dots_per_inch);
/// Returns the least round scale that is at least `n`: 1000, 1500, 2000, 2500, 3000, 4000, 5000, 7500 and ten times
/// these, and so on: a map shrinks by a third at most.
double round_scale_above(double n);

/// Returns the ground shown in a frame of width x height pixels. `required`: must be visible; `free`: the same with a
/// margin, and the frame's proportions. With print.scale: that scale, centred; without, the least round scale at
/// which the content fits; of what is not printed `free`. Throws Error(input) if the content does not fit at
/// print.scale.
Bounds window_at_scale(const Print& print, const Bounds& required, const Bounds& free, int width, int height);

/// The least n at which `required` fits.
double least_scale(const Print& print, const Bounds& required, int width, int height);

/// Returns "1 : 5 000".
std::string scale_words(double n, const Words& words = {});
/// Returns what the scale refers to: "on A4", "printed 27.1 x 20.3 cm".
std::string print_words(const Print& print, double page_width, double page_height, const Words& words = {});

/// Contents of a legend.
struct LegendContent {
    std::string title, unit;
    const ColourScale* scale = nullptr;
    const std::vector<Outline>* outlines = nullptr;
    const std::vector<std::string>* notes = nullptr;
};

/// Returns the preferred width of a legend, at most `most` [px].
double legend_width(const LegendContent& content, const PageStyle& style, const Sheet& sheet, double most);

/// Draws a legend from its upper left corner downwards: title with unit, a box per class (greatest on top), a line per
/// outline, the notes. Returns the y below it.
double draw_legend(const LegendContent& content, const PageStyle& style, Point corner, double width, Sheet& sheet,
                   std::vector<LegendEntry>& entries);

/// Returns the dashes of an outline of this width; empty if it is solid.
std::vector<double> outline_dashes(const Outline& outline, double width_px);

}  // namespace frana::render
