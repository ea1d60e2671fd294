// SPDX-License-Identifier: Apache-2.0
#include "analysis/energy_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "core/reached_raster.h"

namespace frana {
namespace {

// A way along rows, columns and diagonals is at most 1 / cos(22.5 degrees) as long as the straight one.
constexpr double k_straight = 0.923;
constexpr std::pair<std::int64_t, std::int64_t> k_around[] = {{0, 1}, {1, 0},  {0, -1}, {-1, 0},
                                                              {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

/// The line over reached cells, and the lowest ground on the way to them; NaN: no way leads there.
struct HeadLines {
    Raster line, lowest;
    double highest = -std::numeric_limits<double>::infinity();
};

template <class Visit>
void for_neighbours(const GridSpec& grid, std::size_t cell, const Visit& visit) {
    const auto row = static_cast<std::int64_t>(cell) / grid.columns,
               column = static_cast<std::int64_t>(cell) % grid.columns;
    for (const auto& [r, c] : k_around)
        if (row + r >= 0 && row + r < grid.rows && column + c >= 0 && column + c < grid.columns)
            visit(static_cast<std::size_t>((row + r) * grid.columns + column + c), std::hypot(r, c) * grid.cell_size);
}

HeadLines lines_of(const EnergyLineInput& input) {
    HeadLines all{reached_raster(input.bed.grid, k_no_data), reached_raster(input.bed.grid, k_no_data)};
    std::priority_queue<std::pair<double, std::size_t>> next;  // the highest line first
    const auto raise = [&](std::size_t cell, double line, double lowest) {
        if (!(input.depth.values[cell] > 0) || line <= all.line.values[cell]) return;
        all.line.values[cell] = line;
        all.lowest.values[cell] = std::min(lowest, input.bed.values[cell]);
        next.emplace(line, cell);
    };
    input.source.values.for_each_stored([&](std::size_t cell, double head) {
        if (std::isnan(head)) return;
        all.highest = std::max(all.highest, head);
        raise(cell, head, input.bed.values[cell]);
    });
    while (!next.empty()) {
        const auto [line, cell] = next.top();
        next.pop();
        if (line < all.line.values[cell]) continue;  // a better way was found since
        const double lowest = all.lowest.values[cell], loss = k_straight * input.friction(cell);
        for_neighbours(input.bed.grid, cell,
                       [&](std::size_t to, double length) { raise(to, line - loss * length, lowest); });
    }
    return all;
}

/// Half the fall of the flatter side of a cell along its row and column: how much lower its edge is than its middle.
double fall_within(const Raster& bed, std::size_t cell) {
    const auto row = static_cast<std::int64_t>(cell) / bed.grid.columns,
               column = static_cast<std::int64_t>(cell) % bed.grid.columns;
    const auto flatter = [&](std::int64_t r, std::int64_t c) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::int64_t side : {-1, 1}) {
            const std::int64_t at_row = row + side * r, at_column = column + side * c;
            if (at_row < 0 || at_column < 0 || at_row >= bed.grid.rows || at_column >= bed.grid.columns) continue;
            if (const double z = bed.at(at_row, at_column); !std::isnan(z))
                least = std::min(least, std::abs(z - bed.values[cell]));
        }
        return std::isfinite(least) ? 0.5 * least : 0.0;
    };
    return flatter(1, 0) + flatter(0, 1);
}

}  // namespace

EnergyLineExcess energy_line_excess(const EnergyLineInput& input) {
    const HeadLines lines = lines_of(input);
    EnergyLineExcess excess;
    const double cell_area = input.bed.grid.cell_size * input.bed.grid.cell_size;
    input.depth.values.for_each_stored([&](std::size_t cell, double depth) {
        const double speed = input.speed.values[cell], z = input.bed.values[cell];
        if (!(depth > 0) || std::isnan(speed) || std::isnan(z)) return;
        const double known = lines.line.values[cell], line = std::isnan(known) ? lines.highest : known,
                     lowest = std::isnan(known) ? z : lines.lowest.values[cell];
        const double above = z + speed * speed / (2 * input.gravity) - line - input.push - fall_within(input.bed, cell),
                     of_fall = above / (line + input.push - lowest);
        if (!(above > 0) || !std::isfinite(of_fall)) return;
        if (of_fall > k_line_error) excess.volume += depth * cell_area;
        if (of_fall <= excess.of_fall) return;
        excess.of_fall = of_fall;
        excess.height = above;
        excess.place = input.bed.grid.cell_centre(static_cast<std::int64_t>(cell) / input.bed.grid.columns,
                                                  static_cast<std::int64_t>(cell) % input.bed.grid.columns);
    });
    return excess;
}

}  // namespace frana
