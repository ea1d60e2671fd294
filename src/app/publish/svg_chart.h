// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// One line of a chart.
struct SvgSeries {
    std::string label;
    std::string colour;        ///< "#0072b2"
    std::vector<double> x, y;  ///< as many of each; a NaN breaks the line
};

struct SvgChart {
    std::string x_label, y_label;
    std::vector<SvgSeries> series;
    bool log_x = false;  ///< values of 0 and less are left out
};

/// A line chart as an SVG element for an HTML page: axes from round numbers, a grid, a legend. A series of
/// many points is thinned to what the width can show, keeping the least and greatest of each stretch.
std::string svg_chart(const SvgChart& chart);

/// A text with the signs that HTML reads as its own written out.
std::string html_escaped(const std::string& text);

}  // namespace frana::app
