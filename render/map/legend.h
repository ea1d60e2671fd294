// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/colour_scale.h"
#include "render/map/map2d.h"

namespace frana::render {

/// What stands in a legend.
struct LegendContent {
    std::string title, unit;
    const ColourScale* scale = nullptr;
    const std::vector<Outline>* outlines = nullptr;
    const std::vector<std::string>* notes = nullptr;
};

/// Width that a legend wants, at most `most` [px].
double legend_width(const LegendContent& content, const PageStyle& style, const Sheet& sheet, double most);

/// Draws a legend from its upper left corner downwards: title with unit, a box per class (greatest on top), a
/// line per outline, the notes. Returns the y under it.
double draw_legend(const LegendContent& content, const PageStyle& style, Point corner, double width, Sheet& sheet,
                   std::vector<LegendEntry>& entries);

/// Dashes of an outline of this width; empty if it is unbroken.
std::vector<double> outline_dashes(const Outline& outline, double width_px);

}  // namespace frana::render
