// SPDX-License-Identifier: Apache-2.0
#include "render/map/title_block.h"

#include <algorithm>
#include <cmath>

namespace frana::render {
namespace {

constexpr double k_most_of_width = 0.45;  // for the logo
constexpr double k_least_logo = 24;       // px

PageBox logo_box(const Image& logo, const PageBox& place) {
    const double most_wide = k_most_of_width * place.width();
    const double scale = std::min(most_wide / logo.width, place.height() / logo.height);
    const double width = std::floor(logo.width * scale), height = std::floor(logo.height * scale);
    if (width < 1 || height < 1 || std::max(width, height) < k_least_logo) return {};
    const double left = std::floor(place.right - width), top = std::floor(place.top);
    return {left, top, left + width, top + height};
}

}  // namespace

BlockPlace place_title_block(const TitleBlock& block, const PageStyle& style, const Sheet& sheet, Point corner,
                             double width, double most) {
    BlockPlace place;
    double left = width;
    if (block.logo) {
        place.logo = logo_box(*block.logo, {corner.x, corner.y, corner.x + width, corner.y + most});
        if (place.logo.width() > 0) left -= place.logo.width() + style.gap;
        place.height = place.logo.height();
    }
    for (const std::string& line : block.lines)
        for (const std::string& part : sheet.wrapped(line, style.small, left)) place.lines.push_back(part);
    const double height = Sheet::line_height(style.small) * static_cast<double>(place.lines.size());
    if (height > most) {
        place.lines.clear();
        place.lines_at_foot = true;
    } else {
        place.height = std::max(place.height, height);
    }
    return place;
}

void draw_title_block(const BlockPlace& place, const PageStyle& style, Point corner, Sheet& sheet) {
    TextStyle letters = style.small;
    letters.colour = k_ink;
    sheet.lines(place.lines, corner, letters, Across::left);
}

Image logo_picture(const Image& logo, int width, int height) {
    Image small(width, height);
    // Each pixel is the mean of what it covers; a logo that is enlarged keeps its pixels.
    const auto covered = [](int pixel, int pixels, int of) {
        const int from = static_cast<int>(static_cast<std::int64_t>(pixel) * of / pixels);
        const int to = static_cast<int>((static_cast<std::int64_t>(pixel + 1) * of + pixels - 1) / pixels);
        return std::pair(from, std::max(to, from + 1));
    };
    for (int row = 0; row < height; ++row) {
        const auto [top, bottom] = covered(row, height, logo.height);
        for (int column = 0; column < width; ++column) {
            const auto [left, right] = covered(column, width, logo.width);
            std::int64_t sum[3] = {0, 0, 0};
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x)
                    for (int k = 0; k < 3; ++k) sum[k] += logo.pixel(x, y)[k];
            const std::int64_t count = static_cast<std::int64_t>(bottom - top) * (right - left);
            for (int k = 0; k < 3; ++k)
                small.pixel(column, row)[k] = static_cast<std::uint8_t>((sum[k] + count / 2) / count);
        }
    }
    return small;
}

}  // namespace frana::render
