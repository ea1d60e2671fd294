// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"

namespace frana::render {

/// Returns the part of a raster inside a window, reduced by averaging blocks of cells so that neither side has more
/// than `most_cells` of them (a block with a gap is a gap); one cell more on each side if there is one. Empty (no
/// columns) if window and raster do not overlap.
Raster raster_window(const Raster& raster, const Bounds& window, std::int64_t most_cells);

/// Returns the smallest rectangle around all cells with a value; none if there is no value.
std::optional<Bounds> data_bounds(const Raster& raster);

/// Returns the value interpolated bilinearly between cell centres; NaN outside and beside gaps.
double interpolated(const Raster& raster, Point map) noexcept;

/// Returns the value of the cell that contains a point; NaN outside.
inline double cell_value(const Raster& raster, Point map) noexcept {
    const double column = (map.x - raster.grid.west) / raster.grid.cell_size;
    const double row = (raster.grid.north - map.y) / raster.grid.cell_size;
    if (!(column >= 0 && row >= 0 && column < static_cast<double>(raster.grid.columns) &&
          row < static_cast<double>(raster.grid.rows))) {
        return k_no_data;
    }
    return raster.at(static_cast<std::int64_t>(row), static_cast<std::int64_t>(column));
}

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
