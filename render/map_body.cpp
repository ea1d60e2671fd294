// SPDX-License-Identifier: Apache-2.0
#include "render/map_body.h"

#include <algorithm>
#include <cmath>

#include "render/hillshade.h"
#include "render/page_style.h"
#include "render/raster_window.h"

namespace frana::render {

Rgb relief_colour(double shade) {
    // Level ground (0.68 under these lights) comes out light; the darkest slope stays a mid grey, slightly
    // cool, the brightest nearly white and slightly warm.
    const double bright = 128 + 122 * std::pow(std::clamp(shade, 0.0, 1.0), 1.05);
    const double warm = (shade - 0.6) * 12;
    const auto byte = [](double v) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 255.0)));
    };
    return {byte(bright + warm * 0.5), byte(bright), byte(bright - warm)};
}

void paint_relief(Image& page, const MapFrame& frame, const Raster& terrain) {
    const std::int64_t most_cells = 2 * static_cast<std::int64_t>(std::max(frame.width, frame.height));
    const Raster part = raster_window(terrain, frame.window, most_cells);
    if (part.grid.columns == 0) return;
    const Raster shade = hillshade(part);
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            const double value = interpolated(shade, frame.ground(column, row));
            if (std::isnan(value)) continue;
            const Rgb colour = relief_colour(value);
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            p[0] = colour.r;
            p[1] = colour.g;
            p[2] = colour.b;
        }
    }
}

std::int64_t paint_cells(Image& page, const MapFrame& frame, const Raster& layer, const ColourScale& scale) {
    std::int64_t n_coloured = 0;
    for (int row = 0; row < frame.height; ++row) {
        for (int column = 0; column < frame.width; ++column) {
            const ColourClass* found = scale.find(cell_value(layer, frame.ground(column, row)));
            if (found == nullptr) continue;
            std::uint8_t* p = page.pixel(frame.left + column, frame.top + row);
            p[0] = found->colour.r;
            p[1] = found->colour.g;
            p[2] = found->colour.b;
            ++n_coloured;
        }
    }
    return n_coloured;
}

}  // namespace frana::render
