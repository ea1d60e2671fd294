// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_body.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/canvas/image.h"
#include "render/canvas/page.h"
#include "render/map/relief.h"

namespace frana::render {

Bounds MapFrame::ground_bounds() const {
    Ring ring = corners(window);
    for (Point& corner : ring) corner = turn.map(corner);
    return bounds(MultiPolygon{{std::move(ring), {}}});
}

ReliefTones::ReliefTones(const Raster& shade) {
    std::vector<double> values;
    for (const double value : shade.values) {
        if (!std::isnan(value)) values.push_back(value);
    }
    double gamma = 1;
    if (!values.empty()) gamma = fit(values);
    for (int i = 0; i <= k_steps; ++i) {
        const double fraction = std::pow(static_cast<double>(i) / k_steps, gamma);
        // From a cool mid grey to a warm near-white.
        const double bright = 138 + 110 * fraction, warm = 5 * fraction - 2.5;
        const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(v)); };
        tones_[static_cast<std::size_t>(i)] = {byte(bright + warm), byte(bright + 0.4 * warm), byte(bright - warm)};
    }
}

double ReliefTones::fit(std::vector<double>& values) {
    // One cell in a hundred may be a cliff or a wall; these must not determine the tones of the others.
    const auto quantile = [&values](double fraction) {
        const auto place =
            values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    darkest_ = quantile(0.01);
    brightest_ = quantile(0.99);
    constexpr double k_least_range = 0.4;
    const double lacking = k_least_range - (brightest_ - darkest_);
    if (lacking > 0) {
        darkest_ -= lacking / 2;
        brightest_ += lacking / 2;
    }
    // A hillside facing the light would be white all over: its middle is mapped to the middle of the tones.
    constexpr double k_middle_tone = 0.6;
    const double middle = std::clamp((quantile(0.5) - darkest_) / (brightest_ - darkest_), 0.05, 0.95);
    return std::clamp(std::log(k_middle_tone) / std::log(middle), 0.75, 2.5);
}

void paint_relief(Image& page, const MapFrame& frame, const Raster& terrain) {
    const std::int64_t most_cells = 2 * static_cast<std::int64_t>(std::max(frame.width, frame.height));
    const Raster part = raster_window(terrain, frame.ground_bounds(), most_cells);
    if (part.grid.columns == 0) return;
    const Raster shade = hillshade(part);
    const ReliefTones tones(shade);
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            const double value = interpolated(shade, frame.ground(column, row));
            if (std::isnan(value)) continue;
            const Rgb colour = tones.colour(value);
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            p[0] = colour.r;
            p[1] = colour.g;
            p[2] = colour.b;
        }
    }
}

void paint_background(Image& page, const MapFrame& frame, const Background& background) {
    const Bounds box = frame.ground_bounds();
    const double metre = frame.metres_per_pixel();
    const bool turned = frame.turn.deg != 0;
    const int columns = turned ? static_cast<int>(std::ceil(box.width() / metre)) : frame.width,
              rows = turned ? static_cast<int>(std::ceil(box.height() / metre)) : frame.height;
    const OverlayImage picture =
        background({box.west, box.north - rows * metre, box.west + columns * metre, box.north}, columns, rows);
    constexpr double k_lighter = 0.18;  // of the way to white
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            const Point at = frame.ground(column, row);
            const int x = turned ? std::clamp(static_cast<int>((at.x - box.west) / metre), 0, columns - 1) : column,
                      y = turned ? std::clamp(static_cast<int>((box.north - at.y) / metre), 0, rows - 1) : row;
            const std::uint8_t* from =
                picture.rgba.data() +
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x));
            std::uint8_t* to = page.pixel(frame.left + column, frame.top + row);
            for (int k = 0; k < 3; ++k) {  // colours are premultiplied by their opacity
                const double under = to[k] * (255 - from[3]) / 255.0;
                const double lit = from[k] + k_lighter * (from[3] - from[k]);
                to[k] = static_cast<std::uint8_t>(std::lround(under + lit));
            }
        }
    }
}

void paint_dots(Image& page, const MapFrame& frame, const Dots& dots, const ColourScale& scale) {
    const double radius = std::max(0.5, dots.width_m / frame.metres_per_pixel() / 2);
    const PageBox box = frame.box();
    for (const Dot& dot : dots.dots) {
        const ColourClass* found = scale.find(dot.value);
        if (found == nullptr) continue;
        const Point at = frame.page(dot.place);
        const auto paint = [&](int column, int row) {
            if (column < box.left || column >= box.right || row < box.top || row >= box.bottom) return;
            std::uint8_t* p = page.pixel(column, row);
            p[0] = found->colour.r;
            p[1] = found->colour.g;
            p[2] = found->colour.b;
        };
        paint(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
        for (int row = static_cast<int>(at.y - radius); row <= static_cast<int>(at.y + radius); ++row) {
            for (int column = static_cast<int>(at.x - radius); column <= static_cast<int>(at.x + radius); ++column) {
                if (std::hypot(column + 0.5 - at.x, row + 0.5 - at.y) < radius) paint(column, row);
            }
        }
    }
}

void paint_cells(Image& page, const MapFrame& frame, const Raster& layer, const ColourScale& scale, int edge_px) {
    const auto width = static_cast<std::size_t>(frame.width);
    std::vector<char> coloured(width * static_cast<std::size_t>(frame.height));
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            const ColourClass* found = scale.find(cell_value(layer, frame.ground(column, row)));
            if (found == nullptr) continue;
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            p[0] = found->colour.r;
            p[1] = found->colour.g;
            p[2] = found->colour.b;
            coloured[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = 1;
        }
    }
    const auto is_coloured = [&](int column, int row) {
        return column >= 0 && column < frame.width && row >= 0 && row < frame.height &&
               coloured[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] != 0;
    };
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            if (is_coloured(column, row)) continue;
            bool at_edge = false;
            for (int k = 1; k <= edge_px && !at_edge; ++k)
                at_edge = is_coloured(column - k, row) || is_coloured(column + k, row) ||
                          is_coloured(column, row - k) || is_coloured(column, row + k);
            if (!at_edge) continue;
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            for (int k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(p[k] * 2 / 5);
        }
    }
}

}  // namespace frana::render
