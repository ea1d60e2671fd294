// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
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
/// letters that DejaVu lacks in the fonts that fontconfig finds for them. The same shapes at any resolution. Copies
/// share the layout.
class TextLine {
  public:
    /// Control characters become spaces, bytes that are not UTF-8 are escaped, and more than 500 letters are cut off.
    /// Throws Error(environment) if DejaVu Sans is not installed.
    TextLine(const std::string& text, const TextStyle& style);

    /// The ink of the unturned text [px], from the left end of its baseline; y grows downwards. Empty: no ink.
    [[nodiscard]] const PageBox& ink() const noexcept { return ink_; }
    /// Returns the left end of the baseline on the page, if the text's reference point is `at`: in whole pixels.
    [[nodiscard]] Point origin(Point at, const TextStyle& style, Across across, Upright upright) const;

    /// Fills the letters, turned, in the current colour.
    void show(cairo_t* on, Point origin, const TextStyle& style) const;
    /// Adds the letters' rims to the current path.
    void trace(cairo_t* on, Point origin, const TextStyle& style) const;

  private:
    template <class Draw>
    void turned(cairo_t* on, Point origin, const TextStyle& style, const Draw& draw) const;

    std::shared_ptr<PangoLayout> layout_;
    PageBox ink_;
};

/// Returns the letters, each once, for which no installed font had a shape when texts were laid out since the last
/// call: they appear as boxes with their code. Any thread may call it.
std::vector<std::string> take_letters_without_font();

/// Measures texts of one line. Used by one thread at a time: what was laid out is kept.
class Lettering {
  public:
    [[nodiscard]] const TextLine& line(const std::string& text, const TextStyle& style) const;
    /// Width of the ink [px] of an unturned text.
    [[nodiscard]] double width(const std::string& text, const TextStyle& style) const {
        return line(text, style).ink().width();
    }
    /// Returns where the ink of a text would be; if it is turned, the box around its turned box.
    [[nodiscard]] TextBox place(const std::string& text, Point at, const TextStyle& style, Across across,
                                Upright upright) const;

  private:
    using Key = std::tuple<std::string, int, bool>;  // text, size, bold
    mutable std::map<Key, TextLine> kept_;
};

}  // namespace frana::render
