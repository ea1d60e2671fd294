// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "render/canvas/drawing.h"
#include "render/canvas/overlay.h"

namespace frana::render {

/// A page's lines, shapes and texts, and the positions of the texts.
class Sheet : public Drawing {
  public:
    Sheet(int width, int height);

    [[nodiscard]] const std::vector<TextBox>& texts() const noexcept { return boxes_; }

    void line(std::span<const Point> points, const LineStyle& style, bool closed = false) override;
    void fill(std::span<const Point> corners, Rgb colour, double opacity = 1) override;
    using Drawing::fill;
    void frame(const PageBox& box, const LineStyle& style) override;
    void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) override;

    /// Returns everything; the sheet is empty then, but for the positions of its texts.
    [[nodiscard]] Overlay take();

  private:
    std::shared_ptr<Overlay::Content> content_;
    std::vector<TextBox> boxes_;
};

}  // namespace frana::render
