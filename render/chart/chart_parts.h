// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/chart/chart.h"

namespace frana::render {

/// The line of a series or a curve.
LineStyle chart_line(const PageStyle& style, Rgb colour, double width_px, Stroke stroke);

/// A line of the grid inside a panel's frame: upright at x, or level at y.
void grid_upright(Sheet& sheet, const PageBox& box, double x, const LineStyle& line);
void grid_level(Sheet& sheet, const PageBox& box, double y, const LineStyle& line);
/// The numbers along a panel's frame: under it at x, left of it at y.
void number_below(Sheet& sheet, const PageStyle& style, const PageBox& box, double x, const std::string& words);
void number_beside(Sheet& sheet, const PageStyle& style, const PageBox& box, double y, const std::string& words);
/// The name of an upright axis, read from below.
void upright_name(Sheet& sheet, TextStyle style, Point middle, const std::string& words);

/// Names with a swatch before each, in as many rows as a width needs.
class ChartKey {
  public:
    ChartKey(const Sheet& sheet, const TextStyle& style, const std::vector<std::string>& names, double width);

    [[nodiscard]] double height() const noexcept { return height_; }
    /// From the key's upper left corner; `swatch` draws the i-th one between two points.
    void draw(Sheet& sheet, Point corner, const std::function<void(std::size_t i, Point from, Point to)>& swatch) const;

  private:
    TextStyle style_;
    std::vector<std::string> names_;
    std::vector<Point> places_;
    double height_ = 0;
};

}  // namespace frana::render
