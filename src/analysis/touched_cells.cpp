// SPDX-License-Identifier: Apache-2.0
#include "analysis/touched_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace frana {
namespace {

/// Collects cells in coordinates of columns and rows, counted from the north-western corner.
class Collector {
  public:
    explicit Collector(const GridSpec& grid) : grid_(grid) {}

    void add(const MixedShape& shape) {
        for (const Point& point : shape.points) add_place(on_grid(point));
        for (const Polyline& line : shape.lines)
            for (std::size_t i = 0; i < line.size(); ++i)
                add_segment(on_grid(line[i == 0 ? 0 : i - 1]), on_grid(line[i]), false);
        for (const Polygon& polygon : shape.areas) add_area(polygon);
    }
    std::vector<std::size_t> cells() {
        std::sort(cells_.begin(), cells_.end());
        cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
        return std::move(cells_);
    }

  private:
    [[nodiscard]] Point on_grid(Point map) const {
        return {(map.x - grid_.west) / grid_.cell_size, (grid_.north - map.y) / grid_.cell_size};
    }
    void add_cell(double column, double row) {
        if (!(column >= 0 && row >= 0 && column < static_cast<double>(grid_.columns) &&
              row < static_cast<double>(grid_.rows)))
            return;
        cells_.push_back(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                         static_cast<std::size_t>(column));
    }
    void add_place(Point p) { add_cell(std::floor(p.x), std::floor(p.y)); }

    /// The part of a segment within the grid, as fractions of its length.
    bool clip(Point a, Point b, double& from, double& to) const {
        const auto limit = [&](double start, double change, double least, double most) {
            if (change == 0) return start >= least && start <= most;
            const double first = (least - start) / change, second = (most - start) / change;
            from = std::max(from, std::min(first, second));
            to = std::min(to, std::max(first, second));
            return from <= to;
        };
        return limit(a.x, b.x - a.x, 0, static_cast<double>(grid_.columns)) &&
               limit(a.y, b.y - a.y, 0, static_cast<double>(grid_.rows));
    }

    /// Cuts a segment where it crosses borders of cells: each piece lies in the cell of its middle.
    /// @param is_rim of an area: a piece along a border of cells lies in none
    void add_segment(Point a, Point b, bool is_rim) {
        if (a.x == b.x && a.y == b.y) {
            if (!is_rim) add_place(a);
            return;
        }
        double from = 0, to = 1;
        if (!clip(a, b, from, to)) return;
        std::vector<double> cuts{from, to};
        const auto cut = [&](double start, double change) {
            if (change == 0) return;
            const double p = start + from * change, q = start + to * change;
            for (double border = std::ceil(std::min(p, q)); border <= std::max(p, q); border += 1) {
                const double at = (border - start) / change;
                if (at > from && at < to) cuts.push_back(at);
            }
        };
        cut(a.x, b.x - a.x);
        cut(a.y, b.y - a.y);
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            if (!(cuts[i] > cuts[i - 1])) continue;
            const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
            const Point p{a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)};
            const bool along_border = (a.x == b.x && std::floor(a.x) == a.x) || (a.y == b.y && std::floor(a.y) == a.y);
            if (!is_rim || !along_border) add_place(p);
        }
    }

    void add_area(const Polygon& polygon) {
        const auto rim = [&](const Ring& ring) {
            for (std::size_t i = 0; i < ring.size(); ++i)
                add_segment(on_grid(ring[i]), on_grid(ring[(i + 1) % ring.size()]), true);
        };
        rim(polygon.outer);
        for (const Ring& hole : polygon.holes) rim(hole);
        const Bounds box = bounds(MultiPolygon{{polygon.outer, {}}});
        const double top = std::max(0.0, std::floor(on_grid({box.west, box.north}).y)),
                     bottom = std::min(static_cast<double>(grid_.rows), on_grid({box.west, box.south}).y);
        for (double row = top; row < bottom; row += 1) add_inner_cells(polygon, row);
    }

    /// Cells that no rim crosses are inside or outside with their centre.
    void add_inner_cells(const Polygon& polygon, double row) {
        std::vector<double> crossings;
        const double level = row + 0.5;
        const auto cross = [&](const Ring& ring) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = on_grid(ring[i]), b = on_grid(ring[(i + 1) % ring.size()]);
                if ((a.y <= level) != (b.y <= level))
                    crossings.push_back(a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        };
        cross(polygon.outer);
        for (const Ring& hole : polygon.holes) cross(hole);
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const double first = std::max(0.0, std::ceil(crossings[i] - 0.5)),
                         last = std::min(static_cast<double>(grid_.columns), crossings[i + 1] - 0.5);
            for (double column = first; column < last; column += 1) add_cell(column, row);
        }
    }

    const GridSpec& grid_;
    std::vector<std::size_t> cells_;
};

}  // namespace

std::vector<std::size_t> touched_cells(const MixedShape& shape, const GridSpec& grid) {
    Collector collector(grid);
    collector.add(shape);
    return collector.cells();
}

MapPlace place_of(const MixedShape& shape, const Bounds& map) {
    bool any_inside = false, any_outside = false;
    const auto look = [&](Point p) {
        const bool in = p.x >= map.west && p.x <= map.east && p.y >= map.south && p.y <= map.north;
        (in ? any_inside : any_outside) = true;
    };
    for (const Point& point : shape.points) look(point);
    for (const Polyline& line : shape.lines)
        for (const Point& point : line) look(point);
    for (const Polygon& area : shape.areas)
        for (const Point& point : area.outer) look(point);
    if (!any_outside) return MapPlace::inside;
    if (any_inside) return MapPlace::partly;
    // A large feature may cover the map with all its corners outside.
    GridSpec one{map.west, map.north, std::max(map.width(), map.height()), 1, 1, {}};
    return touched_cells(shape, one).empty() ? MapPlace::outside : MapPlace::partly;
}

}  // namespace frana
