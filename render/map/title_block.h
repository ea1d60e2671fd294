// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/map2d.h"

namespace frana::render {

/// Where the parts of a title block are on a page.
struct BlockPlace {
    std::vector<std::string> lines;  ///< broken to the width left of the logo; empty: none, or at the foot
    bool lines_at_foot = false;      ///< there are too many for their place
    PageBox logo;                    ///< empty: none, or it would be too small to be recognised
    double height = 0;
};

/// Arranges a title block in a place beside the title. It never needs more height than `most`: the logo becomes smaller
/// and is omitted if that would make it smaller than 24 pixels; lines that do not fit go to the foot of the page.
BlockPlace place_title_block(const TitleBlock& block, const PageStyle& style, const Sheet& sheet, Point corner,
                             double width, double most);

/// Writes the lines; the caller puts the logo (logo_picture) on the page.
void draw_title_block(const BlockPlace& place, const PageStyle& style, Point corner, Sheet& sheet);

/// Returns a logo in the given number of pixels, averaged.
Image logo_picture(const Image& logo, int width, int height);

}  // namespace frana::render
