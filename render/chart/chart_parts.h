// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/page.h"
#include "render/chart/chart.h"

namespace frana::render {

/// Draws grid lines at the ticks inside a panel's frame, and the numbers along it: below and to the left.
void draw_ticks(Sheet& sheet, const PageStyle& style, const PageBox& box, const std::vector<Tick>& x,
                const std::vector<Tick>& y);
/// Draws the name of a vertical axis, reading upwards.
void draw_vertical_name(Sheet& sheet, TextStyle style, Point middle, const std::string& words);

/// Draws a line through positions on the page, with the series' markers.
void draw_line(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places);
void draw_markers(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places);

/// Names of series with a swatch before each, in as many rows as needed.
class ChartKey {
  public:
    ChartKey(const Sheet& sheet, const TextStyle& letters, std::vector<const ChartSeries*> series, double width);

    [[nodiscard]] double height() const noexcept { return height_; }
    /// `corner`: the key's upper left one.
    void draw(Sheet& sheet, const PageStyle& style, Point corner) const;

  private:
    TextStyle letters_;
    std::vector<const ChartSeries*> series_;
    std::vector<Point> places_;
    double height_ = 0;
};

}  // namespace frana::render
