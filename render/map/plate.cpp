// SPDX-License-Identifier: Apache-2.0
#include "render/map/plate.h"

#include <algorithm>

#include "render/canvas/furniture.h"
#include "render/canvas/page.h"

namespace frana::render {
namespace {

constexpr int k_least_width = 480, k_least_height = 360;  // of a part: a map with its legend needs this size

}  // namespace

Page draw_plate(const Plate& plate, int width, int height, std::vector<TextBox>* texts) {
    const PageStyle style(width, height);
    Sheet sheet(width, height);
    const double inner = width - 2 * style.margin;
    const TitleResult titles =
        draw_titles(sheet, style, plate.title, plate.subtitle, false, {style.margin, style.margin}, inner);
    const double foot_top = draw_foot(sheet, style, {plate.foot}, style.margin, height - style.margin / 2, inner);
    Page page(width, height);
    const int across = std::max(1, plate.across);
    const int down = std::max(1, (static_cast<int>(plate.parts.size()) + across - 1) / across);
    const int top = static_cast<int>(titles.bottom), high = (static_cast<int>(foot_top) - top) / down,
              wide = width / across;
    if (!plate.parts.empty() && (wide < k_least_width || high < k_least_height)) {
        return draw_plate(plate, std::max(width, k_least_width * across),
                          height + down * std::max(0, k_least_height - high), texts);
    }
    for (int i = 0; i < static_cast<int>(plate.parts.size()); ++i)
        page.put(plate.parts[static_cast<std::size_t>(i)](wide, high), wide * (i % across), top + high * (i / across));
    page.put(sheet.take());
    if (texts != nullptr) *texts = sheet.texts();
    return page;
}

}  // namespace frana::render
