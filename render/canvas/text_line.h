// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "render/canvas/map_layout.h"
#include "render/canvas/text_style.h"

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

}  // namespace frana::render
