// SPDX-License-Identifier: Apache-2.0
#include "analysis/trace.h"

#include <algorithm>
#include <cmath>

namespace frana {

Raster trace_mask(const Raster& depth, double threshold) {
    Raster mask(depth.grid);
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        if (value > threshold) mask.values[cell] = 1;
    });
    return mask;
}

double masked_area(const Raster& mask) {
    std::int64_t count = 0;
    mask.values.for_each_stored([&](std::size_t, double value) { count += value != 0 && !std::isnan(value); });
    return static_cast<double>(count) * mask.grid.cell_area();
}

double maximum(const Raster& raster) {
    double largest = k_no_data;
    raster.values.for_each_stored([&](std::size_t, double value) {
        if (!(value <= largest) && !std::isnan(value)) largest = value;
    });
    return largest;
}

Raster padded_to(const Raster& raster, const Bounds& box, double fill) {
    const GridSpec& old = raster.grid;
    const auto cells = [&](double metres) {
        // A millionth of a cell is rounding, not area outside.
        return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(metres / old.cell_size - 1e-6)));
    };
    const std::int64_t left = cells(old.west - box.west), right = cells(box.east - old.east());
    const std::int64_t above = cells(box.north - old.north), below = cells(old.south() - box.south);
    if (left + right + above + below == 0) return raster;

    GridSpec grid = old;
    grid.west = old.west - static_cast<double>(left) * old.cell_size;
    grid.north = old.north + static_cast<double>(above) * old.cell_size;
    grid.columns = old.columns + left + right;
    grid.rows = old.rows + above + below;
    Raster padded(grid, fill);
    for (std::int64_t row = 0; row < old.rows; ++row) {
        const auto from = raster.values.begin() + static_cast<std::ptrdiff_t>(raster.index(row, 0));
        std::copy(from, from + old.columns,
                  padded.values.begin() + static_cast<std::ptrdiff_t>(padded.index(row + above, left)));
    }
    return padded;
}

Raster cut_to(const Raster& raster, const CellWindow& window) {
    if (raster.values.empty()) return raster;
    if (window.rows * window.columns <= CellValues::k_most_dense) return part_of(raster, window);
    Raster part(part_of(raster.grid, window), k_no_data);
    const std::int64_t columns = raster.grid.columns;
    raster.values.for_each_stored([&](std::size_t cell, double value) {
        const std::int64_t row = static_cast<std::int64_t>(cell) / columns - window.row,
                           column = static_cast<std::int64_t>(cell) % columns - window.column;
        if (std::isnan(value) || row < 0 || column < 0 || row >= window.rows || column >= window.columns) return;
        part.at(row, column) = value;
    });
    return part;
}

}  // namespace frana
