// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/drawing.h"
#include "render/canvas/page.h"
#include "render/chart/chart.h"

namespace frana::render {

/// Draws grid lines at the ticks inside a panel's frame, and the numbers along it: below and to the left.
void draw_ticks(Drawing& drawing, const PageStyle& style, const PageBox& box, const std::vector<Tick>& x,
                const std::vector<Tick>& y);
/// Draws the name of a vertical axis, reading upwards.
void draw_vertical_name(Drawing& drawing, TextStyle style, Point middle, const std::string& words);

/// Draws a line through positions on the page, with the series' markers.
void draw_line(Drawing& drawing, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places);
void draw_markers(Drawing& drawing, const PageStyle& style, const ChartSeries& series,
                  const std::vector<Point>& places);

/// Names of series with a swatch before each, in as many rows as needed.
class ChartKey {
  public:
    ChartKey(const Drawing& drawing, const TextStyle& letters, std::vector<const ChartSeries*> series, double width);

    [[nodiscard]] double height() const noexcept { return height_; }
    /// `corner`: the key's upper left one.
    void draw(Drawing& drawing, const PageStyle& style, Point corner) const;

  private:
    TextStyle letters_;
    std::vector<const ChartSeries*> series_;
    std::vector<Point> places_;
    double height_ = 0;
};

}  // namespace frana::render
