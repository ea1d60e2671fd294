// SPDX-License-Identifier: Apache-2.0
#include "analysis/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>
#include "core/reached_raster.h"

namespace frana {
namespace {

// The window of positive cells with a rim of one cell, and the area of each of its cells: 0 is none.
struct Areas {
    std::int64_t row = 0, column = 0, rows = 0, columns = 0;
    std::vector<std::int32_t> of_cell;
    std::int32_t count = 0;

    [[nodiscard]] std::size_t index(std::int64_t r, std::int64_t c) const {
        return static_cast<std::size_t>(r * columns + c);
    }
};

constexpr std::int32_t k_not_yet = -1;

// Gives all cells connected with the last of `open` by edges its area.
void spread(Areas& areas, std::vector<std::pair<std::int64_t, std::int64_t>>& open) {
    while (!open.empty()) {
        const auto [r, c] = open.back();
        open.pop_back();
        for (const auto& [dr, dc] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            std::int32_t& area = areas.of_cell[areas.index(r + dr, c + dc)];
            if (area != k_not_yet) continue;
            area = areas.count;
            open.emplace_back(r + dr, c + dc);
        }
    }
}

Areas areas_where_positive(const GridSpec& grid, std::span<const double> values) {
    std::int64_t top = grid.rows, bottom = -1, left = grid.columns, right = -1;
    for (std::int64_t r = 0; r < grid.rows; ++r) {
        for (std::int64_t c = 0; c < grid.columns; ++c) {
            if (!(values[static_cast<std::size_t>(r * grid.columns + c)] > 0)) continue;
            top = std::min(top, r);
            bottom = r;
            left = std::min(left, c);
            right = std::max(right, c);
        }
    }
    Areas areas;
    if (bottom < 0) return areas;
    areas.row = top - 1;
    areas.column = left - 1;
    areas.rows = bottom - top + 3;
    areas.columns = right - left + 3;
    areas.of_cell.assign(static_cast<std::size_t>(areas.rows * areas.columns), 0);
    for (std::int64_t r = top; r <= bottom; ++r)
        for (std::int64_t c = left; c <= right; ++c)
            if (values[static_cast<std::size_t>(r * grid.columns + c)] > 0)
                areas.of_cell[areas.index(r - areas.row, c - areas.column)] = k_not_yet;
    std::vector<std::pair<std::int64_t, std::int64_t>> open;
    for (std::int64_t r = 0; r < areas.rows; ++r) {
        for (std::int64_t c = 0; c < areas.columns; ++c) {
            std::int32_t& area = areas.of_cell[areas.index(r, c)];
            if (area != k_not_yet) continue;
            area = ++areas.count;
            open.emplace_back(r, c);
            spread(areas, open);
        }
    }
    return areas;
}

// Directions, each a left turn from the one before: east, north, west, south.
constexpr int k_directions = 4;
constexpr std::array<std::int64_t, k_directions> k_step_row{0, -1, 0, 1}, k_step_column{1, 0, -1, 0};

// A corner of cells: the north-western one of the cell with its row and column.
using Corner = std::pair<std::int64_t, std::int64_t>;

// The edges of one area that start at a corner, with the area on their left; at most two.
using Edges = std::map<Corner, std::array<bool, k_directions>>;

std::vector<Edges> edges_of(const Areas& areas) {
    std::vector<Edges> edges(static_cast<std::size_t>(areas.count));
    for (std::int64_t r = 1; r + 1 < areas.rows; ++r) {
        for (std::int64_t c = 1; c + 1 < areas.columns; ++c) {
            const std::int32_t area = areas.of_cell[areas.index(r, c)];
            if (area == 0) continue;
            Edges& own = edges[static_cast<std::size_t>(area - 1)];
            const auto is_edge = [&](std::int64_t other_row, std::int64_t other_column) {
                return areas.of_cell[areas.index(other_row, other_column)] != area;
            };
            if (is_edge(r + 1, c)) own[{r + 1, c}][0] = true;
            if (is_edge(r, c + 1)) own[{r + 1, c + 1}][1] = true;
            if (is_edge(r - 1, c)) own[{r, c + 1}][2] = true;
            if (is_edge(r, c - 1)) own[{r, c}][3] = true;
        }
    }
    return edges;
}

// Follows edges from a corner until it is back, and removes them. Where cells touch at a corner only, it turns left:
// along the same cell.
std::vector<Corner> take_ring(Edges& edges) {
    std::vector<Corner> ring;
    const Corner first = edges.begin()->first;
    Corner at = first;
    int direction = -1;
    do {
        auto& there = edges.at(at);
        int next = 0;
        if (direction < 0) {
            while (!there[static_cast<std::size_t>(next)]) ++next;
        } else {
            next = (direction + 1) % k_directions;
            while (!there[static_cast<std::size_t>(next)]) next = (next + k_directions - 1) % k_directions;
        }
        if (next != direction) ring.push_back(at);
        const auto d = static_cast<std::size_t>(next);
        there[d] = false;
        if (std::none_of(there.begin(), there.end(), [](bool edge) { return edge; })) edges.erase(at);
        at = {at.first + k_step_row[d], at.second + k_step_column[d]};
        direction = next;
    } while (at != first);
    return ring;
}

}  // namespace

MultiPolygon outlines_where_positive(const GridSpec& grid, std::span<const double> values) {
    const Areas areas = areas_where_positive(grid, values);
    MultiPolygon outlines;
    for (Edges& edges : edges_of(areas)) {
        // The first corner in the order of rows is one of the outer ring.
        Polygon& polygon = outlines.emplace_back();
        while (!edges.empty()) {
            Ring ring;
            for (const Corner& corner : take_ring(edges))
                ring.push_back({grid.west + static_cast<double>(areas.column + corner.second) * grid.cell_size,
                                grid.north - static_cast<double>(areas.row + corner.first) * grid.cell_size});
            if (polygon.outer.empty())
                polygon.outer = std::move(ring);
            else
                polygon.holes.push_back(std::move(ring));
        }
    }
    return outlines;
}

Raster trace_mask(const Raster& depth, double threshold) {
    Raster mask = reached_raster(depth.grid, 0);
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

namespace {

constexpr double k_unreached = std::numeric_limits<double>::infinity();

/// Replaces the squared distances along one axis by those in the plane: the least (i - k)^2 + f(k), by the lower
/// envelope of parabolas (Felzenszwalb & Huttenlocher 2012, Theory of Computing 8, 415).
void add_axis(std::vector<double>& f, std::vector<double>& from, std::vector<std::size_t>& roots) {
    roots.clear();
    from.clear();
    const auto square = [](std::size_t i) { return static_cast<double>(i) * static_cast<double>(i); };
    for (std::size_t i = 0; i < f.size(); ++i) {
        if (f[i] == k_unreached) continue;
        double meets = -k_unreached;
        while (!roots.empty()) {
            const std::size_t k = roots.back();
            meets = (f[i] + square(i) - f[k] - square(k)) / (2 * static_cast<double>(i - k));
            if (meets > from.back()) break;
            roots.pop_back();
            from.pop_back();
            meets = -k_unreached;
        }
        roots.push_back(i);
        from.push_back(meets);
    }
    if (roots.empty()) return;
    const std::vector<double> old = f;
    for (std::size_t i = 0, at = 0; i < f.size(); ++i) {
        while (at + 1 < roots.size() && from[at + 1] < static_cast<double>(i)) ++at;
        const double apart = static_cast<double>(i) - static_cast<double>(roots[at]);
        f[i] = apart * apart + old[roots[at]];
    }
}

/// Distances in cells from the nearest cell that is `kind`.
std::vector<double> distances_to(const std::vector<char>& cells, std::size_t columns, char kind) {
    std::vector<double> squares(cells.size()), line, from;
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < cells.size(); ++i) squares[i] = cells[i] == kind ? 0 : k_unreached;
    const auto along = [&](std::size_t first, std::size_t step, std::size_t count) {
        line.resize(count);
        for (std::size_t i = 0; i < count; ++i) line[i] = squares[first + i * step];
        add_axis(line, from, roots);
        for (std::size_t i = 0; i < count; ++i) squares[first + i * step] = line[i];
    };
    for (std::size_t column = 0; column < columns; ++column) along(column, columns, cells.size() / columns);
    for (std::size_t first = 0; first < cells.size(); first += columns) along(first, 1, columns);
    for (double& square : squares) square = std::sqrt(square);
    return squares;
}

}  // namespace

std::vector<double> distances_from_rim(const std::vector<char>& inside, std::size_t columns) {
    const std::vector<double> in = distances_to(inside, columns, 1), out = distances_to(inside, columns, 0);
    const double farthest =
        std::hypot(static_cast<double>(columns), static_cast<double>(inside.size()) / static_cast<double>(columns));
    std::vector<double> distances;
    for (std::size_t i = 0; i < inside.size(); ++i)
        distances.push_back(inside[i] != 0 ? std::min(out[i] - 0.5, farthest) : std::max(0.5 - in[i], -farthest));
    return distances;
}

}  // namespace frana
