// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/colour.h"

namespace frana::render {

/// A picture of opaque pixels, three bytes each (red, green, blue), row by row from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;

    Image() = default;
    Image(int columns, int rows, Rgb fill = {255, 255, 255});

    /// First byte of a pixel; column 0 and row 0 are the upper left corner.
    [[nodiscard]] std::uint8_t* pixel(int column, int row) noexcept {
        return rgb.data() +
               3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
    }
    [[nodiscard]] const std::uint8_t* pixel(int column, int row) const noexcept {
        return const_cast<Image*>(this)->pixel(column, row);
    }
    [[nodiscard]] Rgb colour(int column, int row) const noexcept {
        const std::uint8_t* p = pixel(column, row);
        return {p[0], p[1], p[2]};
    }
};

/// Returns the image as PNG; `dots_per_inch`, if not 0, specifies its printed size. Throws Error(environment) if the
/// image is empty.
std::string png_bytes(const Image& image, double dots_per_inch = 0);

/// Writes a PNG, aside first and then renamed, so that `path` is complete or unchanged. Throws Error(environment) if it
/// cannot be written (unwritable folder, full disk) or the image is empty.
void write_png(const std::string& path, const Image& image, double dots_per_inch = 0);

}  // namespace frana::render
