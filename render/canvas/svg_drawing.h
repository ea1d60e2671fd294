// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/canvas/drawing.h"

namespace frana::render {

/// A page as an SVG element for an HTML page: sharp at every size.
class SvgDrawing : public Drawing {
  public:
    SvgDrawing(int width, int height) : width_(width), height_(height) {}

    void line(std::span<const Point> points, const LineStyle& style, bool closed = false) override;
    void fill(std::span<const Point> corners, Rgb colour, double opacity = 1) override;
    using Drawing::fill;
    void frame(const PageBox& box, const LineStyle& style) override;
    void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) override;

    /// Returns the drawing so far.
    [[nodiscard]] std::string svg() const;
    /// Returns the same as a part of another element, with its upper left corner there; what is beyond its edges is
    /// cut off.
    [[nodiscard]] std::string part(int left, int top) const;

  private:
    int width_, height_;
    std::string shapes_, texts_;
};

}  // namespace frana::render
