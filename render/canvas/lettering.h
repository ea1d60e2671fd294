// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/colour.h"
#include "core/grid_spec.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"

namespace frana::render {

struct TextStyle {
    int size_px = 16;
    Rgb colour{0, 0, 0};
    bool bold = false;
    double angle_deg = 0;  ///< counterclockwise
    double halo_px = 0;    ///< width of a rim that separates the letters from a varied background
    Rgb halo{255, 255, 255};
};

/// The point of a text that is at the place given for it.
enum class Across { left, centre, right };
enum class Upright { baseline, middle, top };  ///< of capital letters, so that lines of text align

/// Coverage of each pixel by a text's ink (255: whole), in page orientation (rows downwards), trimmed to the ink.
struct Glyphs {
    int left = 0, top = 0;  ///< of the first pixel, from the upper left corner of the page
    int width = 0, height = 0;
    std::vector<std::uint8_t> ink;
};

TextBox text_box(const std::string& text, const Glyphs& glyphs, const TextStyle& style);

/// Draws the letters, and before them their halo, on a page; anything outside it is cut off.
void blend(Image& page, const Glyphs& glyphs, const TextStyle& style);

/// Writes and measures one-line texts in DejaVu Sans, with VTK's FreeType. Used by one thread at a time: rendered texts
/// are cached.
class Lettering {
  public:
    /// Throws Error(environment) if the font is not installed.
    Lettering();

    /// Width of the ink [px] of an unturned text.
    [[nodiscard]] double width(const std::string& text, const TextStyle& style) const;
    /// Height of a capital letter [px].
    [[nodiscard]] static double capital_height(const TextStyle& style) { return 0.729 * style.size_px; }

    /// Returns the letters of a text at a place.
    [[nodiscard]] Glyphs set(const std::string& text, Point at, const TextStyle& style, Across across,
                             Upright upright) const;
    /// Returns where the ink of a text would be.
    [[nodiscard]] TextBox place(const std::string& text, Point at, const TextStyle& style, Across across,
                                Upright upright) const;
    /// Writes a text and returns where its ink is.
    TextBox write(Image& page, const std::string& text, Point at, const TextStyle& style, Across across,
                  Upright upright) const;

  private:
    /// Letters as VTK draws them, trimmed to the ink, which may be none.
    struct Drawn {
        int first_column = 0, last_row = 0;  ///< of the ink in VTK's picture, whose rows go upwards
        double descent = 0;                  ///< from the lower edge of VTK's box to the baseline
        Glyphs glyphs;
    };
    [[nodiscard]] const Drawn& drawn(const std::string& text, const TextStyle& style) const;
    /// Placed at the origin.
    [[nodiscard]] Glyphs set(const std::string& text, const TextStyle& style, Across across, Upright upright) const;

    using Key = std::tuple<std::string, int, bool, double>;  // text, size, bold, angle
    std::string regular_, bold_;
    mutable std::map<Key, Drawn> kept_;
};

}  // namespace frana::render
