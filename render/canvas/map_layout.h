// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "core/grid_spec.h"

namespace frana::render {

/// A rectangle of the page in pixels; y grows downwards from the upper edge.
struct PageBox {
    double left = 0, top = 0, right = 0, bottom = 0;

    [[nodiscard]] double width() const noexcept { return right - left; }
    [[nodiscard]] double height() const noexcept { return bottom - top; }
    [[nodiscard]] bool overlaps(const PageBox& other) const noexcept {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    [[nodiscard]] bool inside(const PageBox& other) const noexcept {
        return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
    }
};

/// A piece of text and the pixels that its ink covers.
struct TextBox {
    std::string text;
    PageBox box;
    double size_px = 0;  ///< font size
};

/// One filled box of the legend and its class.
struct LegendEntry {
    std::string label;
    Rgb colour;
    PageBox box;
    double lower = 0, upper = 0;  ///< bounds of the class; for a category both are its value
};

/// Places of everything drawn, for tests and for placing further things on a map.
struct MapLayout {
    PageBox page;
    PageBox map;    ///< inside of the frame
    Bounds window;  ///< coordinates of the page (MapTurn) shown inside the frame
    MapTurn turn;
    double metres_per_pixel = 0;  ///< the same in both directions
    double scale = 0;             ///< n of 1 : n when printed; 0: not printed
    PageBox title_block;          ///< empty: none, or its lines are at the foot
    PageBox logo;                 ///< empty: none, or there is no room
    PageBox scale_bar;
    double scale_bar_metres = 0;
    double north_arrow_deg = 0;  ///< clockwise from straight up on the page
    PageBox north_arrow;
    double font_px = 0;  ///< of ordinary labels
    std::vector<TextBox> texts;
    std::vector<LegendEntry> legend;
};

}  // namespace frana::render
