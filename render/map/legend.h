// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/colour_scale.h"
#include "render/map/map2d.h"

namespace frana::render {

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
