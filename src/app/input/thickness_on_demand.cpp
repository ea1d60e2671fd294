// SPDX-License-Identifier: Apache-2.0
#include "app/input/thickness_on_demand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frana::app {

Raster thickness_on_demand(ThicknessSpec::Kind kind, const GridSpec& grid,
                           const std::vector<std::shared_ptr<const gis::RasterOnDemand>>& files,
                           const std::shared_ptr<const gis::RasterOnDemand>& ground) {
    CellValues::Source source;
    if (kind == ThicknessSpec::Kind::raster) {
        source = [file = files[0]](const CellWindow& window, double* values) { file->read(window, values); };
    } else {
        const auto above = kind == ThicknessSpec::Kind::difference ? files[0] : ground;
        const auto below = kind == ThicknessSpec::Kind::difference ? files[1] : files[0];
        source = [above, below](const CellWindow& window, double* values) {
            std::vector<double> lower(static_cast<std::size_t>(window.rows * window.columns));
            above->read(window, values);
            below->read(window, lower.data());
            for (std::size_t i = 0; i < lower.size(); ++i) {
                const double lowered = values[i] - lower[i];
                values[i] = std::isnan(lowered) ? k_no_data : std::max(lowered, 0.0);
            }
        };
    }
    Raster thickness;
    thickness.grid = grid;
    thickness.values = CellValues::tiled(grid.rows, grid.columns, k_no_data, std::move(source));
    return thickness;
}

namespace {

// Calls visit(row, column, value) for the positive cells within an extent, reading part by part.
template <class Visit>
void for_each_positive(const Raster& thickness, const Bounds& extent, const Visit& visit) {
    constexpr std::int64_t k_part = 8 * CellValues::k_side;
    const GridSpec& grid = thickness.grid;
    const auto cells = [&](double metres, std::int64_t most) {
        return static_cast<std::int64_t>(std::clamp(metres / grid.cell_size, 0.0, static_cast<double>(most)));
    };
    const std::int64_t first_row = cells(grid.north - extent.north, grid.rows) / k_part * k_part,
                       first_column = cells(extent.west - grid.west, grid.columns) / k_part * k_part,
                       last_row = std::min(cells(grid.north - extent.south, grid.rows) + 1, grid.rows),
                       last_column = std::min(cells(extent.east - grid.west, grid.columns) + 1, grid.columns);
    for (std::int64_t row = first_row; row < last_row; row += k_part) {
        for (std::int64_t column = first_column; column < last_column; column += k_part) {
            const CellWindow window{row, column, std::min(k_part, grid.rows - row),
                                    std::min(k_part, grid.columns - column)};
            // The copy, and what it reads, lasts for this part only.
            const Raster unread = thickness;
            for (std::int64_t r = row; r < row + window.rows; ++r)
                for (std::int64_t c = column; c < column + window.columns; ++c)
                    if (const double value = std::as_const(unread).at(r, c); value > 0) visit(r, c, value);
        }
    }
}

}  // namespace

Raster positive_cells(const Raster& thickness, const Bounds& extent) {
    Raster mask(thickness.grid);
    for_each_positive(thickness, extent,
                      [&](std::int64_t row, std::int64_t column, double) { mask.at(row, column) = 1; });
    return mask;
}

Raster positive_values(const Raster& thickness, const Bounds& extent) {
    Raster values(thickness.grid, k_no_data);
    for_each_positive(thickness, extent,
                      [&](std::int64_t row, std::int64_t column, double value) { values.at(row, column) = value; });
    return values;
}

}  // namespace frana::app
