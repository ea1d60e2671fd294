// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"

namespace frana::render {

/// Font size of the smallest letters of a page on a screen [px].
inline constexpr int k_least_letters = 9;

struct TextStyle {
    int size_px = 16;
    Rgb colour{0, 0, 0};
    bool bold = false;
    double angle_deg = 0;  ///< counterclockwise
    double halo_px = 0;    ///< width of a rim that separates the letters from a varied background
    Rgb halo{255, 255, 255};
    int least_px = k_least_letters;  ///< to which the text may be made smaller to fit
};

/// The point of a text that is at the place given for it.
enum class Across { left, centre, right };
enum class Upright { baseline, middle, top };  ///< of capital letters, so that lines of text align

/// Height of a capital letter of DejaVu Sans [px].
inline double capital_height(const TextStyle& style) {
    return 0.729 * style.size_px;
}
}  // namespace frana::render

using cairo_t = struct _cairo;
using PangoLayout = struct _PangoLayout;

namespace frana::render {

/// A text of one line in DejaVu Sans, laid out by Pango: every script in its own direction and joined as it is written,
/// letters that DejaVu lacks in the fonts that fontconfig finds for them. The same shapes at any resolution.
class TextLine {
  public:
    /// Control characters become spaces, bytes that are not UTF-8 are escaped, and more than 500 letters are cut off.
    /// Throws Error(environment) if DejaVu Sans is not installed.
    TextLine(const std::string& text, const TextStyle& style);

    /// The ink of the unturned text [px], from the left end of its baseline; y grows downwards. Empty: no ink.
    [[nodiscard]] const PageBox& ink() const noexcept { return ink_; }
    /// Returns the left end of the baseline on the page, if the text's reference point is `at`.
    [[nodiscard]] Point origin(Point at, Across across, Upright upright) const;

    /// Fills the letters, turned, in the current colour.
    void show(cairo_t* on, Point origin) const;
    /// Adds the letters' rims to the current path.
    void trace(cairo_t* on, Point origin) const;

  private:
    void turn(cairo_t* on, Point origin) const;

    std::shared_ptr<PangoLayout> layout_;
    TextStyle style_;
    PageBox ink_;
};

/// Returns the letters, each once, for which no installed font had a shape when texts were laid out since the last
/// call: they appear as boxes with their code. Any thread may call it.
std::vector<std::string> take_letters_without_font();

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
