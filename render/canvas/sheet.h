// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/canvas/canvas.h"
#include "render/canvas/lettering.h"

namespace frana::render {

/// Drawn lines and shapes with the texts over them, ready to be put on one picture after the other.
class Overlay {
  public:
    void put(Image& page) const;

  private:
    friend class Sheet;
    struct Text {
        Glyphs glyphs;
        TextStyle style;
    };
    LayerImage shapes_;
    std::vector<Text> texts_;
};

/// Lines, shapes and texts that will lie over a picture, and where the texts are.
class Sheet {
  public:
    Sheet(int width, int height) : canvas_(width, height) {}

    [[nodiscard]] Canvas& canvas() noexcept { return canvas_; }
    [[nodiscard]] const Lettering& lettering() const noexcept { return lettering_; }
    [[nodiscard]] const std::vector<TextBox>& texts() const noexcept { return boxes_; }

    /// Puts a text over all lines and shapes.
    const TextBox& text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright);
    /// The lines one below the other, from the capitals' top of the first; returns the y under the last.
    double lines(const std::vector<std::string>& words, Point top, const TextStyle& style, Across across);

    /// Words broken into lines no wider than `width`; a single longer word is cut with an ellipsis.
    [[nodiscard]] std::vector<std::string> wrapped(const std::string& words, const TextStyle& style,
                                                   double width) const;
    /// From one line's capitals to the next line's [px].
    [[nodiscard]] static double line_height(const TextStyle& style) { return 1.35 * style.size_px; }

    /// Throws Error(environment) when VTK or OpenGL fails.
    [[nodiscard]] Overlay draw() const;

  private:
    Canvas canvas_;
    Lettering lettering_;
    std::vector<Overlay::Text> texts_;
    std::vector<TextBox> boxes_;
};

}  // namespace frana::render
