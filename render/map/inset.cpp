// SPDX-License-Identifier: Apache-2.0
#include "render/map/inset.h"

#include <algorithm>
#include <cmath>

namespace frana::render {

std::optional<MapFrame> inset_frame(const Bounds& terrain, const Bounds& window, const PageStyle& style,
                                    const PageBox& room) {
    constexpr double k_nearly_all = 0.7;  // a rectangle along the edge shows nothing
    const double shown_width = std::min(window.east, terrain.east) - std::max(window.west, terrain.west);
    const double shown_height = std::min(window.north, terrain.north) - std::max(window.south, terrain.south);
    if (shown_width * shown_height > k_nearly_all * terrain.width() * terrain.height()) return std::nullopt;
    const double metres_per_pixel =
        std::max(terrain.width() / room.width(), terrain.height() / std::max(1.0, room.height()));
    MapFrame inset;
    inset.width = static_cast<int>(terrain.width() / metres_per_pixel);
    inset.height = static_cast<int>(terrain.height() / metres_per_pixel);
    const double least = 3.5 * style.label.size_px;
    if (inset.width < least || inset.height < least) return std::nullopt;
    inset.left = static_cast<int>(std::lround(room.left));
    inset.top = static_cast<int>(room.top);
    inset.window = {terrain.west, terrain.north - inset.height * terrain.width() / inset.width, terrain.east,
                    terrain.north};  // square pixels
    return inset;
}

Image draw_inset(Sheet& sheet, const PageStyle& style, const MapFrame& inset, const Raster& terrain,
                 const Bounds& window) {
    Image picture(inset.width, inset.height, k_no_terrain);
    paint_relief(picture, inset.alone(), terrain);
    const PageBox box = inset.box();
    const Point low = inset.page({window.west, window.south}), high = inset.page({window.east, window.north});
    const PageBox shown{std::max(low.x, box.left), std::max(high.y, box.top), std::min(high.x, box.right),
                        std::min(low.y, box.bottom)};
    constexpr Rgb k_here{180, 0, 40};
    sheet.frame(shown, {style.line(2) + 2 * style.line(1.2), {255, 255, 255}});
    sheet.frame(shown, {style.line(2), k_here});
    sheet.frame(box, {style.line(1.2), k_ink});
    return picture;
}

}  // namespace frana::render
