// SPDX-License-Identifier: Apache-2.0
#include "analysis/taken_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

namespace frana {
namespace {

// The cells of the path within a square of 2 `by` + 1 cells round any of these, by sums over the corners of squares.
Raster widened(const std::vector<std::size_t>& cells, std::int64_t by, const Raster& path) {
    const GridSpec& grid = path.grid;
    const std::int64_t width = grid.columns + 1;
    std::vector<std::int32_t> squares(static_cast<std::size_t>(width * (grid.rows + 1)));
    const auto corner = [&](std::int64_t row, std::int64_t column) -> std::int32_t& {
        return squares[static_cast<std::size_t>(row * width + column)];
    };
    for (const std::size_t cell : cells) {
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        const std::int64_t top = std::max<std::int64_t>(row - by, 0), bottom = std::min(row + by + 1, grid.rows),
                           left = std::max<std::int64_t>(column - by, 0),
                           right = std::min(column + by + 1, grid.columns);
        ++corner(top, left);
        --corner(top, right);
        --corner(bottom, left);
        ++corner(bottom, right);
    }
    Raster wide(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        std::int32_t sum = 0;
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            sum += corner(row, column);
            corner(row, column) = sum + (row > 0 ? corner(row - 1, column) : 0);
            if (corner(row, column) > 0 && path.at(row, column) > 0) wide.at(row, column) = 1;
        }
    }
    return wide;
}

}  // namespace

Raster taken_path(const Raster& ground, const Raster& path, double cell_size, std::optional<GroundDoubts::Dam>& dam) {
    constexpr double k_dam = 5, k_narrow = 30, k_narrow_cells = 2.5;  // [m]
    const GridSpec& grid = ground.grid;
    const auto centre_of = [&](std::size_t cell) {
        const auto at = static_cast<std::int64_t>(cell);
        return grid.cell_centre(at / grid.columns, at % grid.columns);
    };
    std::set<std::tuple<double, std::size_t, std::size_t>> front;  // elevation, order, cell: where it came first
    std::size_t order = 0;
    constexpr auto k_untouched = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> from(static_cast<std::size_t>(grid.cell_count()),
                                  k_untouched);  // the cell that water came from
    std::vector<std::size_t> taken;
    double starts = 0;
    path.values.for_each_stored([&](std::size_t cell, double on) {
        if (!(on > 1) || std::isnan(ground.values[cell])) return;
        starts += 1;
        front.emplace(ground.values[cell], ++order, cell);
        from[cell] = cell;
    });
    const auto side = static_cast<std::int64_t>(std::clamp(std::sqrt(starts) / 2, 2.0, 30.0));
    const auto beside = [&](std::size_t cell, const auto& visit) {
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        for (std::int64_t r = std::max<std::int64_t>(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
            for (std::int64_t c = std::max<std::int64_t>(column - 1, 0); c <= std::min(column + 1, grid.columns - 1);
                 ++c)
                visit(ground.index(r, c));
    };
    const double narrow = std::max(k_narrow / cell_size, k_narrow_cells) * grid.cell_size;  // of the grid's unit
    double floor = HUGE_VAL, level = HUGE_VAL;  // of the water where it is dammed up
    // The lowest first, as water rises: it leaves the path at its lowest end.
    for (bool ends = false; !front.empty() && !ends;) {
        const auto [z, at, cell] = front.extract(front.begin()).value();
        if (z < floor) {
            const Point here = centre_of(cell);
            std::size_t crest = cell;
            const auto is_near = [&](Point p) { return std::hypot(here.x - p.x, here.y - p.y) <= narrow; };
            while (ground.values[crest] < level && from[crest] != crest && is_near(centre_of(from[crest])))
                crest = from[crest];
            if (ground.values[crest] >= level && level - floor > std::max(k_dam, dam ? dam->height : 0))
                dam = {level - floor, centre_of(crest)};
            floor = level = z;
        }
        level = std::max(level, z);
        taken.push_back(cell);
        beside(cell, [&](std::size_t i) {
            if (std::isnan(ground.values[i])) return;
            ends = ends || !(path.values[i] > 0);
            if (from[i] != k_untouched) return;
            from[i] = cell;
            front.emplace(ground.values[i], ++order, i);
        });
    }
    return widened(taken, side, path);
}

}  // namespace frana
