// SPDX-License-Identifier: Apache-2.0
// Every line against every edge: slow, and the reference for fill_outline.
#include "simple_fill.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frana::test {
namespace {

// Edges of overlapping parts may cross within a row; the crossings are not computed: the row is divided this often
// instead.
constexpr int k_divisions = 8;
constexpr double k_gauss = 0.57735026918962576;  // 1 / sqrt(3)

struct Interval {
    double from, to;
};

// Intersects a polygon with a horizontal line, as intervals inside it (even-odd, holes excluded).
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
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) inside.push_back({crossings[i], crossings[i + 1]});
}

// Sorts and joins intervals that overlap: area covered twice counts once.
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

// Calls visit(a, b) for every edge of the outline.
template <class Visit>
void for_each_edge(const MultiPolygon& outline, const Visit& visit) {
    const auto walk = [&](const Ring& ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) visit(ring[j], ring[i]);
    };
    for (const Polygon& polygon : outline) {
        if (!polygon.outer.empty()) walk(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            if (!hole.empty()) walk(hole);
        }
    }
}

// Returns the y within a row of the lattice at which the outline bends or crosses from one column to the next, with the
// row's ends: between two of them the outline's edges are straight within each cell.
std::vector<double> strip_edges(const MultiPolygon& outline, double from, double to, double spacing) {
    std::vector<double> edges{from, to};
    const int divisions = outline.size() > 1 ? k_divisions : 1;
    for (int k = 1; k < divisions; ++k) edges.push_back(from + (to - from) * k / divisions);
    for_each_edge(outline, [&](Point a, Point b) {
        const double low = std::max(std::min(a.y, b.y), from), high = std::min(std::max(a.y, b.y), to);
        if (!(low < high)) return;
        if (low > from) edges.push_back(low);
        if (high < to) edges.push_back(high);
        if (a.x == b.x) return;
        const double slope = (b.x - a.x) / (b.y - a.y);
        const double one = a.x + (low - a.y) * slope, other = a.x + (high - a.y) * slope;
        for (double column = std::floor(std::min(one, other) / spacing) + 1; column * spacing < std::max(one, other);
             ++column)
            edges.push_back(std::clamp(a.y + (column * spacing - a.x) / slope, low, high));
    });
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace

double simple_fill(const MultiPolygon& outline, double spacing, const std::function<double(Point)>& thickness,
                   ParticleSet& particles) {
    const Bounds box = bounds(outline);
    const auto first_column = static_cast<std::int64_t>(std::floor(box.west / spacing));
    const auto last_column = static_cast<std::int64_t>(std::floor(box.east / spacing));
    const auto first_row = static_cast<std::int64_t>(std::floor(box.south / spacing));
    const auto last_row = static_cast<std::int64_t>(std::floor(box.north / spacing));
    std::vector<Covered> cells(static_cast<std::size_t>(last_column - first_column + 1));
    std::vector<double> crossings;
    std::vector<Interval> inside;
    double volume = 0;
    for (std::int64_t row = first_row; row <= last_row; ++row) {
        std::fill(cells.begin(), cells.end(), Covered{});
        const std::vector<double> edges =
            strip_edges(outline, static_cast<double>(row) * spacing, static_cast<double>(row + 1) * spacing, spacing);
        for (std::size_t strip = 0; strip + 1 < edges.size(); ++strip) {
            const double half = 0.5 * (edges[strip + 1] - edges[strip]);
            if (!(half > 0)) continue;
            // Gauss's two points: exact for the area and the moments, which are quadratic in y within a strip.
            for (const double side : {-1.0, 1.0}) {
                const double y = edges[strip] + half * (1 + side * k_gauss);
                inside.clear();
                for (const Polygon& polygon : outline) cut(polygon, y, crossings, inside);
                join(inside);
                for (const Interval& piece : inside) {
                    const auto from = static_cast<std::int64_t>(std::floor(piece.from / spacing));
                    const auto to = std::min(static_cast<std::int64_t>(std::floor(piece.to / spacing)), last_column);
                    for (std::int64_t column = from; column <= to; ++column) {
                        const double west = std::max(piece.from, static_cast<double>(column) * spacing);
                        const double east = std::min(piece.to, static_cast<double>(column + 1) * spacing);
                        if (east <= west) continue;
                        Covered& cell = cells[static_cast<std::size_t>(column - first_column)];
                        const double piece_area = (east - west) * half;
                        cell.area += piece_area;
                        cell.moment_x += piece_area * 0.5 * (east + west);
                        cell.moment_y += piece_area * y;
                    }
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

}  // namespace frana::test
