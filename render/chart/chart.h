// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"

namespace frana::render {

/// Strokes tell lines apart where colours are not to be had: in print without colours.
enum class Stroke { solid, dashed, dotted, dash_dot };

enum class Marker { circle, square, triangle, diamond };

/// Points of one kind, joined by a line in the order given.
struct ChartSeries {
    std::string label;  ///< in the page's legend, once for all panels that share it
    Rgb colour;
    Marker marker = Marker::circle;
    Stroke stroke = Stroke::solid;
    std::vector<Point> points;  ///< both coordinates positive; others cannot be drawn and are left out
};

/// One pair of logarithmic axes.
struct ChartPanel {
    std::string title;
    std::vector<ChartSeries> series;
    std::string note;  ///< written in the panel where it has no point to show
};

/// A page of panels side by side and one below the other, all with the same quantities on their axes.
struct ChartContent {
    std::string title, subtitle;
    std::string x_label, y_label;
    int panels_across = 4;
    std::vector<ChartPanel> panels;
};

/// Decades that a panel shows: whole powers of ten round all its points, 10^low to 10^high.
struct Decades {
    int low = 0, high = 1;
};
/// Of the positive values; 1 to 10 where there is none.
Decades decades_of(const std::vector<double>& values);

/// Where things were drawn, for tests.
struct ChartLayout {
    std::vector<PageBox> panels;  ///< the insides of the frames
    std::vector<TextBox> texts;
    std::vector<std::vector<Point>> points;  ///< of each series of each panel, in pixels
};

/// Draws the page; `layout`, if given, receives where things are. Throws Error(environment) when fonts or
/// OpenGL fail.
Image draw_chart(const ChartContent& content, int width, int height, ChartLayout* layout = nullptr);

}  // namespace frana::render
