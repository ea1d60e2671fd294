// SPDX-License-Identifier: Apache-2.0
#include "particles/seeding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frana {
namespace {

constexpr int k_lines = 8;  // scan lines a lattice row, at least

struct Interval {
    double from, to;
};

// Where a horizontal line crosses a polygon, as intervals inside it (even-odd, holes respected).
void cut(const Polygon& polygon, double y, std::vector<double>& crossings, std::vector<Interval>& inside) {
    crossings.clear();
    const auto cross = [&](const Ring& ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Point a = ring[i], b = ring[j];
            if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    };
    if (polygon.outer.empty()) return;
    cross(polygon.outer);
    for (const Ring& hole : polygon.holes) {
        if (!hole.empty()) cross(hole);
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        inside.push_back({crossings[i], crossings[i + 1]});
}

// Sorts and joins intervals that overlap: parts drawn twice count once.
void join(std::vector<Interval>& intervals) {
    std::sort(intervals.begin(), intervals.end(), [](Interval a, Interval b) { return a.from < b.from; });
    std::size_t kept = 0;
    for (const Interval& next : intervals) {
        if (kept > 0 && next.from <= intervals[kept - 1].to) {
            intervals[kept - 1].to = std::max(intervals[kept - 1].to, next.to);
        } else {
            intervals[kept++] = next;
        }
    }
    intervals.resize(kept);
}

struct Covered {
    double area = 0, moment_x = 0, moment_y = 0;  // of the strips inside a lattice cell
};

// Heights at which the outline bends, within (from, to), with the two ends and an even division between:
// between two of them every strip's width changes linearly, so its middle line gives its area exactly.
std::vector<double> strip_edges(const std::vector<double>& vertex_heights, double from, double to) {
    std::vector<double> edges;
    for (int line = 0; line <= k_lines; ++line) edges.push_back(from + (to - from) * line / k_lines);
    for (auto y = std::upper_bound(vertex_heights.begin(), vertex_heights.end(), from);
         y != vertex_heights.end() && *y < to; ++y) {
        edges.push_back(*y);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

std::vector<double> heights_of(const MultiPolygon& outline) {
    std::vector<double> heights;
    for (const Polygon& polygon : outline) {
        for (const Point& p : polygon.outer) heights.push_back(p.y);
        for (const Ring& hole : polygon.holes) {
            for (const Point& p : hole) heights.push_back(p.y);
        }
    }
    std::sort(heights.begin(), heights.end());
    return heights;
}

}  // namespace

double fill_outline(const MultiPolygon& outline, double spacing,
                    const std::function<double(Point)>& thickness, ParticleSet& particles) {
    const Bounds box = bounds(outline);
    const auto first_column = static_cast<std::int64_t>(std::floor(box.west / spacing));
    const auto last_column = static_cast<std::int64_t>(std::floor(box.east / spacing));
    const auto first_row = static_cast<std::int64_t>(std::floor(box.south / spacing));
    const auto last_row = static_cast<std::int64_t>(std::floor(box.north / spacing));
    std::vector<Covered> cells(static_cast<std::size_t>(last_column - first_column + 1));
    std::vector<double> crossings;
    std::vector<Interval> inside;
    const std::vector<double> vertex_heights = heights_of(outline);
    double volume = 0;
    for (std::int64_t row = first_row; row <= last_row; ++row) {
        std::fill(cells.begin(), cells.end(), Covered{});
        const std::vector<double> edges = strip_edges(vertex_heights, static_cast<double>(row) * spacing,
                                                      static_cast<double>(row + 1) * spacing);
        for (std::size_t strip = 0; strip + 1 < edges.size(); ++strip) {
            const double height = edges[strip + 1] - edges[strip],
                         y = 0.5 * (edges[strip + 1] + edges[strip]);
            if (!(height > 0)) continue;
            inside.clear();
            for (const Polygon& polygon : outline) cut(polygon, y, crossings, inside);
            join(inside);
            for (const Interval& piece : inside) {
                const auto from = static_cast<std::int64_t>(std::floor(piece.from / spacing));
                const auto to =
                    std::min(static_cast<std::int64_t>(std::floor(piece.to / spacing)), last_column);
                for (std::int64_t column = from; column <= to; ++column) {
                    const double west = std::max(piece.from, static_cast<double>(column) * spacing);
                    const double east = std::min(piece.to, static_cast<double>(column + 1) * spacing);
                    if (east <= west) continue;
                    Covered& cell = cells[static_cast<std::size_t>(column - first_column)];
                    const double piece_area = (east - west) * height;
                    cell.area += piece_area;
                    cell.moment_x += piece_area * 0.5 * (east + west);
                    cell.moment_y += piece_area * y;
                }
            }
        }
        for (const Covered& cell : cells) {
            if (!(cell.area > 1e-9 * spacing * spacing)) continue;
            const Point centre{cell.moment_x / cell.area, cell.moment_y / cell.area};
            const double depth = thickness(centre);
            if (!(depth > 0)) continue;
            ParticleRow particle = ParticleSet::initial_row();
            get(particle, Field::x) = centre.x;
            get(particle, Field::y) = centre.y;
            get(particle, Field::area) = cell.area;
            get(particle, Field::volume) = depth * get(particle, Field::area);
            volume += get(particle, Field::volume);
            particles.push_back(particle);
        }
    }
    return volume;
}

}  // namespace frana
