// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/canvas/text_line.h"
#include "render/canvas/text_style.h"

namespace frana::render {

/// Coverage of each pixel by a text's ink (255: whole), in page orientation (rows downwards), trimmed to the ink.
struct Glyphs {
    int left = 0, top = 0;  ///< of the first pixel, from the upper left corner of the page
    int width = 0, height = 0;
    std::vector<std::uint8_t> ink;
};

TextBox text_box(const std::string& text, const Glyphs& glyphs, const TextStyle& style);

/// Draws the letters, and before them their halo, on a page, moved to the right and down; anything outside it is cut
/// off.
void blend(Image& page, const Glyphs& glyphs, const TextStyle& style, int right = 0, int down = 0);

/// Writes and measures texts of one line. Used by one thread at a time: letters are cached.
class Lettering {
  public:
    /// Width of the ink [px] of an unturned text.
    [[nodiscard]] double width(const std::string& text, const TextStyle& style) const;

    /// Returns the letters of a text at a place. Throws Error(environment) if they cannot be drawn.
    [[nodiscard]] Glyphs set(const std::string& text, Point at, const TextStyle& style, Across across,
                             Upright upright) const;
    /// Returns where the ink of a text would be.
    [[nodiscard]] TextBox place(const std::string& text, Point at, const TextStyle& style, Across across,
                                Upright upright) const;
    /// Writes a text and returns where its ink is.
    TextBox write(Image& page, const std::string& text, Point at, const TextStyle& style, Across across,
                  Upright upright) const;

  private:
    /// A text's letters with the left end of their baseline at the origin, which is the corner of a pixel.
    struct Drawn {
        explicit Drawn(TextLine&& laid_out) : line(std::move(laid_out)) {}
        TextLine line;
        Glyphs glyphs;
    };
    const Drawn& drawn(const std::string& text, const TextStyle& style) const;

    using Key = std::tuple<std::string, int, bool, double>;  // text, size, bold, angle
    mutable std::map<Key, Drawn> kept_;
    mutable std::map<Key, double> widths_;
};

}  // namespace frana::render
