// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/lettering.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include "core/error.h"

namespace frana::render {
namespace {

/// Returns the bounds of a box turned counterclockwise about the origin, in whole pixels.
PageBox turned(const PageBox& box, double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    PageBox all{1e9, 1e9, -1e9, -1e9};
    for (const double x : {box.left, box.right}) {
        for (const double y : {box.top, box.bottom}) {
            const double to_x = c * x + s * y, to_y = c * y - s * x;
            all = {std::min(all.left, to_x), std::min(all.top, to_y), std::max(all.right, to_x),
                   std::max(all.bottom, to_y)};
        }
    }
    return {std::floor(all.left), std::floor(all.top), std::ceil(all.right), std::ceil(all.bottom)};
}

[[noreturn]] void fail(const std::string& text, cairo_status_t status) {
    throw Error(ErrorKind::environment,
                Problem{"a text could not be drawn", "Cairo", text, cairo_status_to_string(status), ""});
}

/// Cuts off the rows and columns without ink.
void trim(Glyphs& glyphs) {
    const int width = glyphs.width;
    int first_column = width, last_column = -1, first_row = glyphs.height, last_row = -1;
    for (int row = 0; row < glyphs.height; ++row) {
        for (int column = 0; column < width; ++column) {
            if (glyphs.ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(column)] == 0)
                continue;
            first_column = std::min(first_column, column);
            last_column = std::max(last_column, column);
            first_row = std::min(first_row, row);
            last_row = std::max(last_row, row);
        }
    }
    if (last_column < 0) {
        glyphs = {};
        return;
    }
    Glyphs inside{glyphs.left + first_column,
                  glyphs.top + first_row,
                  last_column - first_column + 1,
                  last_row - first_row + 1,
                  {}};
    for (int row = first_row; row <= last_row; ++row) {
        const auto begin = glyphs.ink.begin() + static_cast<std::ptrdiff_t>(row) * width + first_column;
        inside.ink.insert(inside.ink.end(), begin, begin + inside.width);
    }
    glyphs = std::move(inside);
}

}  // namespace

const Lettering::Drawn& Lettering::drawn(const std::string& text, const TextStyle& style) const {
    const Key key{text, style.size_px, style.bold, style.angle_deg};
    if (const auto known = kept_.find(key); known != kept_.end()) return known->second;
    Drawn& drawn = kept_.emplace(key, Drawn(TextLine(text, style))).first->second;
    const PageBox& ink = drawn.line.ink();
    if (!(ink.width() > 0)) return drawn;
    constexpr int k_rim = 2;  // a pixel's share of a letter beside it
    const PageBox box = turned(ink, style.angle_deg);
    Glyphs& glyphs = drawn.glyphs;
    glyphs.left = static_cast<int>(box.left) - k_rim;
    glyphs.top = static_cast<int>(box.top) - k_rim;
    glyphs.width = static_cast<int>(box.width()) + 2 * k_rim;
    glyphs.height = static_cast<int>(box.height()) + 2 * k_rim;
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_A8, glyphs.width, glyphs.height), &cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> on(cairo_create(surface.get()), &cairo_destroy);
    drawn.line.show(on.get(), {static_cast<double>(-glyphs.left), static_cast<double>(-glyphs.top)});
    cairo_surface_flush(surface.get());
    if (const cairo_status_t status = cairo_status(on.get()); status != CAIRO_STATUS_SUCCESS) fail(text, status);
    const unsigned char* pixels = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int row = 0; row < glyphs.height; ++row) {
        const unsigned char* begin = pixels + static_cast<std::ptrdiff_t>(row) * stride;
        glyphs.ink.insert(glyphs.ink.end(), begin, begin + glyphs.width);
    }
    trim(glyphs);
    return drawn;
}

Glyphs Lettering::set(const std::string& text, Point at, const TextStyle& style, Across across, Upright upright) const {
    const Drawn& letters = drawn(text, style);
    Glyphs glyphs = letters.glyphs;
    const Point origin = letters.line.origin(at, across, upright);
    glyphs.left += static_cast<int>(std::lround(origin.x));
    glyphs.top += static_cast<int>(std::lround(origin.y));
    return glyphs;
}

double Lettering::width(const std::string& text, const TextStyle& style) const {
    const auto [place, is_new] = widths_.try_emplace({text, style.size_px, style.bold, 0});
    if (is_new) place->second = TextLine(text, style).ink().width();
    return place->second;
}

TextBox text_box(const std::string& text, const Glyphs& glyphs, const TextStyle& style) {
    const double left = glyphs.left, top = glyphs.top;
    return {text, {left, top, left + glyphs.width, top + glyphs.height}, static_cast<double>(style.size_px)};
}

TextBox Lettering::place(const std::string& text, Point at, const TextStyle& style, Across across,
                         Upright upright) const {
    return text_box(text, set(text, at, style, across, upright), style);
}

TextBox Lettering::write(Image& page, const std::string& text, Point at, const TextStyle& style, Across across,
                         Upright upright) const {
    const Glyphs glyphs = set(text, at, style, across, upright);
    blend(page, glyphs, style);
    return text_box(text, glyphs, style);
}

void blend(Image& page, const Glyphs& glyphs, const TextStyle& style, int right, int down) {
    const int left = glyphs.left + right, top = glyphs.top + down;
    const auto mix = [&page](int column, int row, Rgb colour, double fraction) {
        if (column < 0 || row < 0 || column >= page.width || row >= page.height) return;
        std::uint8_t* pixel = page.pixel(column, row);
        const std::array<std::uint8_t, 3> ink{colour.r, colour.g, colour.b};
        for (std::size_t k = 0; k < 3; ++k)
            pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] + (ink[k] - pixel[k]) * fraction));
    };
    const auto coverage = [&](int column, int row) -> int {
        if (column < 0 || row < 0 || column >= glyphs.width || row >= glyphs.height) return 0;
        return glyphs.ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(glyphs.width) +
                          static_cast<std::size_t>(column)];
    };
    if (style.halo_px > 0 && glyphs.width > 0) {
        const int reach = static_cast<int>(std::ceil(style.halo_px));
        struct Near {
            int dx, dy;
            double fraction;
        };
        std::vector<Near> nears;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                const double fraction = std::clamp(style.halo_px + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
                if (fraction > 0) nears.push_back({dx, dy, fraction});
            }
        }
        for (int row = -reach; row < glyphs.height + reach; ++row) {
            for (int column = -reach; column < glyphs.width + reach; ++column) {
                double most = 0;
                for (const Near& one : nears)
                    most = std::max(most, one.fraction * coverage(column + one.dx, row + one.dy));
                if (most > 0) mix(left + column, top + row, style.halo, most / 255);
            }
        }
    }
    for (int row = 0; row < glyphs.height; ++row) {
        for (int column = 0; column < glyphs.width; ++column) {
            if (const int fraction = coverage(column, row); fraction > 0)
                mix(left + column, top + row, style.colour, fraction / 255.0);
        }
    }
}

}  // namespace frana::render
