// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/drawing.h"

namespace frana::render {

/// Drawn lines and shapes with the texts over them, to be blended onto several pictures.
class Overlay {
  public:
    void put(Image& page) const;

  private:
    friend class Sheet;
    struct Text {
        Glyphs glyphs;
        TextStyle style;
    };
    OverlayImage shapes_;
    std::vector<Text> texts_;
};

/// Lines, shapes and texts over a picture, and the positions of the texts.
class Sheet : public Drawing {
  public:
    Sheet(int width, int height) : canvas_(width, height) {}

    [[nodiscard]] Canvas& canvas() noexcept { return canvas_; }
    [[nodiscard]] const std::vector<TextBox>& texts() const noexcept { return boxes_; }

    void line(std::span<const Point> points, const LineStyle& style, bool closed = false) override;
    void fill(std::span<const Point> corners, Rgb colour, double opacity = 1) override;
    void frame(const PageBox& box, const LineStyle& style) override;
    void text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) override;

    /// Throws Error(environment) if VTK or OpenGL fails.
    [[nodiscard]] Overlay draw() const;

  private:
    Canvas canvas_;
    std::vector<Overlay::Text> texts_;
    std::vector<TextBox> boxes_;
};

}  // namespace frana::render
