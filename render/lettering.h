// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/colour.h"
#include "core/grid_spec.h"
#include "render/image.h"
#include "render/map_layout.h"
#include "render/osmesa_window.h"

namespace frana::render {

struct TextStyle {
    int size_px = 16;
    Rgb colour{0, 0, 0};
    bool bold = false;
    double angle_deg = 0;  ///< counterclockwise
    double halo_px = 0;    ///< width of a rim that lifts the letters off a busy ground
    Rgb halo{255, 255, 255};
};

/// Which point of a text lies at the place given for it.
enum class Across { left, centre, right };
enum class Upright { baseline, middle, top };  ///< of capital letters, so that lines of text align

/// Writes and measures one-line texts in DejaVu Sans, with VTK's FreeType.
class Lettering {
  public:
    /// Throws Error(environment) when the font is not installed.
    Lettering();

    /// Width of the ink [px] of an unturned text.
    [[nodiscard]] double width(const std::string& text, const TextStyle& style) const;
    /// Height of a capital letter [px].
    [[nodiscard]] static double capital_height(const TextStyle& style) { return 0.729 * style.size_px; }

    /// Where the ink of a text would be.
    [[nodiscard]] TextBox place(const std::string& text, Point at, const TextStyle& style, Across across,
                                Upright upright) const;
    /// Writes a text (what leaves the picture is cut off) and returns where its ink is.
    TextBox write(Image& page, const std::string& text, Point at, const TextStyle& style, Across across,
                  Upright upright) const;
    TextBox write(LayerImage& layer, const std::string& text, Point at, const TextStyle& style, Across across,
                  Upright upright) const;

  private:
    struct Glyphs;
    [[nodiscard]] Glyphs set(const std::string& text, const TextStyle& style, Across across,
                             Upright upright) const;

    template <class Blend>
    TextBox ink(const Blend& blend, const std::string& text, Point at, const TextStyle& style, Across across,
                Upright upright) const;

    std::string regular_, bold_;
};

}  // namespace frana::render
