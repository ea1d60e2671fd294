// SPDX-License-Identifier: Apache-2.0
#include "particles/seeding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/geometry.h"

namespace frana {
namespace {

/// The part of a lattice cell covered by an outline: its area and first moments about the origin.
struct Covered {
    double area = 0, moment_x = 0, moment_y = 0;
};

/// Computes the part of each cell of a square lattice that an outline covers: exactly, except where edges of
/// overlapping parts cross. Holes count as outside, area in several parts counts once. The lattice is anchored at the
/// origin.
///
/// The cost grows with the number of vertices times its logarithm, whatever the outline's shape.
class LatticeCover {
  public:
    LatticeCover(const MultiPolygon& outline, double spacing);

    [[nodiscard]] std::int64_t first_row() const noexcept { return first_row_; }
    [[nodiscard]] std::int64_t last_row() const noexcept { return last_row_; }

    /// Returns the cells of one row from west to east; valid until the next call. Rows must be requested from south to
    /// north.
    const std::vector<Covered>& row(std::int64_t row);

  private:
    struct Edge {
        Point from, to;  // in the ring's order
        double low, high;
        std::size_t polygon;
        double sense;  // +1: the polygon's inside is to the left
    };
    struct Band;

    void add_ring(const Ring& ring, std::size_t polygon, bool hole);
    void enter_row(double from, double to);
    [[nodiscard]] std::vector<double> strip_heights(const Band& band) const;
    [[nodiscard]] bool too_many_strips(const Band& band) const;
    void cover_by_strips(const std::vector<double>& heights);
    void cover_along_edges(const Band& band);
    void add_piece(const Band& band, std::int64_t column, Point from, Point to, double sense);

    double spacing_;
    std::int64_t first_row_, last_row_, first_column_, last_column_;
    std::size_t parts_;
    bool parts_are_apart_;
    std::vector<Edge> edges_;  // by their lower ends
    std::size_t entered_ = 0;
    std::vector<std::size_t> active_;  // edges in the row, by their lower ends
    std::vector<Covered> cells_;
    std::vector<std::pair<double, double>> beyond_;  // height and its first moment of pieces that end in a cell
};

// Edges of overlapping parts may cross within a row; the crossings are not computed: the row is divided into this many
// strips instead.
constexpr int k_divisions = 8;
constexpr double k_gauss = 0.57735026918962576;  // 1 / sqrt(3)
// Number of crossings of lines with edges in a row beyond which following the edges is faster.
constexpr double k_most_crossings = 4e6;

struct Interval {
    double from, to;
};

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

bool counter_clockwise(const Ring& ring) {
    const Point o = ring.front();
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += (ring[i].x - o.x) * (ring[i + 1].y - o.y) - (ring[i + 1].x - o.x) * (ring[i].y - o.y);
    return twice > 0;
}

// Whether no two parts can overlap, judged by their bounding boxes; with many parts this is not checked.
bool apart(const MultiPolygon& outline) {
    constexpr std::size_t k_few = 100;
    if (outline.size() > k_few) return false;
    std::vector<Bounds> boxes;
    for (const Polygon& polygon : outline) {
        const Bounds box = bounds({polygon});
        for (const Bounds& b : boxes) {
            if (box.west < b.east && b.west < box.east && box.south < b.north && b.south < box.north) return false;
        }
        boxes.push_back(box);
    }
    return true;
}

struct LatticeCover::Band {
    double from, to;
};

LatticeCover::LatticeCover(const MultiPolygon& outline, double spacing)
    : spacing_(spacing), parts_(outline.size()), parts_are_apart_(apart(outline)) {
    const Bounds box = bounds(outline);
    first_column_ = static_cast<std::int64_t>(std::floor(box.west / spacing));
    last_column_ = static_cast<std::int64_t>(std::floor(box.east / spacing));
    first_row_ = static_cast<std::int64_t>(std::floor(box.south / spacing));
    last_row_ = static_cast<std::int64_t>(std::floor(box.north / spacing));
    cells_.resize(static_cast<std::size_t>(last_column_ - first_column_ + 1));
    beyond_.resize(cells_.size());
    for (std::size_t p = 0; p < outline.size(); ++p) {
        if (outline[p].outer.empty()) continue;
        add_ring(outline[p].outer, p, false);
        for (const Ring& hole : outline[p].holes) add_ring(hole, p, true);
    }
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.low < b.low; });
}

void LatticeCover::add_ring(const Ring& ring, std::size_t polygon, bool hole) {
    if (ring.empty()) return;
    const double sense = counter_clockwise(ring) != hole ? 1 : -1;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point a = ring[j], b = ring[i];
        if (a.y != b.y) edges_.push_back({a, b, std::min(a.y, b.y), std::max(a.y, b.y), polygon, sense});
    }
}

void LatticeCover::enter_row(double from, double to) {
    std::erase_if(active_, [&](std::size_t e) { return edges_[e].high <= from; });
    for (; entered_ < edges_.size() && edges_[entered_].low < to; ++entered_)
        if (edges_[entered_].high > from) active_.push_back(entered_);
}

// Returns the y at which the outline bends or crosses from one column to the next within a row, with the row's ends:
// between two of them the outline's edges are straight within each cell.
std::vector<double> LatticeCover::strip_heights(const Band& band) const {
    const auto [from, to] = band;
    std::vector<double> heights{from, to};
    const int divisions = parts_ > 1 ? k_divisions : 1;
    for (int k = 1; k < divisions; ++k) heights.push_back(from + (to - from) * k / divisions);
    for (const std::size_t e : active_) {
        const Point a = edges_[e].from, b = edges_[e].to;
        const double low = std::max(edges_[e].low, from), high = std::min(edges_[e].high, to);
        if (low > from) heights.push_back(low);
        if (high < to) heights.push_back(high);
        if (a.x == b.x) continue;
        const double slope = (b.x - a.x) / (b.y - a.y);
        const double one = a.x + (low - a.y) * slope, other = a.x + (high - a.y) * slope;
        for (double column = std::floor(std::min(one, other) / spacing_) + 1; column * spacing_ < std::max(one, other);
             ++column)
            heights.push_back(std::clamp(a.y + (column * spacing_ - a.x) / slope, low, high));
    }
    std::sort(heights.begin(), heights.end());
    return heights;
}

// Whether there are too many strips for integration strip by strip. Their number is estimated first: a million long
// edges would give too many to list.
bool LatticeCover::too_many_strips(const Band& band) const {
    double strips = 0;
    for (const std::size_t e : active_) {
        const Point a = edges_[e].from, b = edges_[e].to;
        const double part = (std::min(edges_[e].high, band.to) - std::max(edges_[e].low, band.from)) / spacing_;
        strips += 1 + part * std::abs((b.x - a.x) / (b.y - a.y));
    }
    if (strips * static_cast<double>(cells_.size()) > k_most_crossings) return true;
    const std::vector<double> heights = strip_heights(band);
    double work = static_cast<double>(heights.size()) * static_cast<double>(cells_.size());
    for (const std::size_t e : active_) {
        const auto first = std::lower_bound(heights.begin(), heights.end(), std::max(edges_[e].low, band.from));
        const auto last = std::lower_bound(first, heights.end(), std::min(edges_[e].high, band.to));
        work += static_cast<double>(last - first);
    }
    return work > k_most_crossings;
}

void LatticeCover::cover_by_strips(const std::vector<double>& heights) {
    std::vector<std::size_t> crossed;
    std::vector<std::pair<std::size_t, double>> crossings;  // polygon, x
    std::vector<Interval> inside;
    std::size_t next = 0;
    const auto cut = [&](double y) {
        for (; next < active_.size() && edges_[active_[next]].low <= y; ++next) crossed.push_back(active_[next]);
        std::erase_if(crossed, [&](std::size_t e) { return edges_[e].high <= y; });
        crossings.clear();
        for (const std::size_t e : crossed) {
            const Point a = edges_[e].to, b = edges_[e].from;
            crossings.emplace_back(edges_[e].polygon, a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
        std::sort(crossings.begin(), crossings.end());
        inside.clear();
        // Every ring is closed: each polygon is crossed an even number of times.
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            inside.push_back({crossings[i].second, crossings[i + 1].second});
        join(inside);
    };
    for (std::size_t strip = 0; strip + 1 < heights.size(); ++strip) {
        const double half = 0.5 * (heights[strip + 1] - heights[strip]);
        if (!(half > 0)) continue;
        // Gauss's two points: exact for the area and the moments, which are quadratic in y within a strip.
        for (const double side : {-1.0, 1.0}) {
            const double y = heights[strip] + half * (1 + side * k_gauss);
            cut(y);
            for (const Interval& piece : inside) {
                const auto from = static_cast<std::int64_t>(std::floor(piece.from / spacing_));
                const auto to = std::min(static_cast<std::int64_t>(std::floor(piece.to / spacing_)), last_column_);
                for (std::int64_t column = from; column <= to; ++column) {
                    const double west = std::max(piece.from, static_cast<double>(column) * spacing_);
                    const double east = std::min(piece.to, static_cast<double>(column + 1) * spacing_);
                    if (east <= west) continue;
                    Covered& cell = cells_[static_cast<std::size_t>(column - first_column_)];
                    const double piece_area = (east - west) * half;
                    cell.area += piece_area;
                    cell.moment_x += piece_area * 0.5 * (east + west);
                    cell.moment_y += piece_area * y;
                }
            }
        }
    }
}

// A piece of an edge within one cell bounds the area to its west: in its own cell by Green's theorem, in the cells
// further west the full width between its ends.
void LatticeCover::add_piece(const Band& band, std::int64_t column, Point from, Point to, double sense) {
    const auto c = static_cast<std::size_t>(std::clamp(column, first_column_, last_column_) - first_column_);
    const double west = static_cast<double>(first_column_ + static_cast<std::int64_t>(c)) * spacing_;
    const auto across = [&](double x) { return std::clamp(x - west, 0.0, spacing_); };
    const double u0 = across(from.x), u1 = across(to.x), v0 = from.y - band.from, v1 = to.y - band.from;
    const double rise = sense * (v1 - v0);
    Covered& cell = cells_[c];
    cell.area += rise * (u0 + u1) / 2;
    cell.moment_x += rise * (u0 * u0 + u0 * u1 + u1 * u1) / 6;
    cell.moment_y += rise * (2 * u0 * v0 + u0 * v1 + u1 * v0 + 2 * u1 * v1) / 6;
    beyond_[c].first += rise;
    beyond_[c].second += rise * (v0 + v1) / 2;
}

void LatticeCover::cover_along_edges(const Band& band) {
    std::fill(beyond_.begin(), beyond_.end(), std::pair<double, double>{});
    for (const std::size_t e : active_) {
        const Edge& edge = edges_[e];
        const Point a = edge.from, b = edge.to;
        const double low = std::max(edge.low, band.from), high = std::min(edge.high, band.to);
        const double slope = (b.x - a.x) / (b.y - a.y), sense = edge.sense * (b.y > a.y ? 1 : -1);
        Point at{a.x + (low - a.y) * slope, low};
        const Point end{a.x + (high - a.y) * slope, high};
        const auto column_of = [&](double x) { return static_cast<std::int64_t>(std::floor(x / spacing_)); };
        const std::int64_t last = column_of(end.x), step = end.x > at.x ? 1 : -1;
        for (std::int64_t column = column_of(at.x); column != last; column += step) {
            const double x = static_cast<double>(step > 0 ? column + 1 : column) * spacing_;
            const Point next{x, std::clamp(a.y + (x - a.x) / slope, at.y, high)};
            add_piece(band, column, at, next, sense);
            at = next;
        }
        add_piece(band, last, at, end, sense);
    }
    double height = 0, moment = 0;  // of the area bounded further east
    for (std::size_t c = cells_.size(); c-- > 0;) {
        Covered& cell = cells_[c];
        cell.area += spacing_ * height;
        cell.moment_x += spacing_ * spacing_ / 2 * height;
        cell.moment_y += spacing_ * moment;
        height += beyond_[c].first;
        moment += beyond_[c].second;
        cell.area = std::clamp(cell.area, 0.0, spacing_ * spacing_);
        const auto inside = [&](double m) { return std::clamp(m, 0.0, cell.area * spacing_); };
        cell.moment_x = inside(cell.moment_x) +
                        cell.area * static_cast<double>(first_column_ + static_cast<std::int64_t>(c)) * spacing_;
        cell.moment_y = inside(cell.moment_y) + cell.area * band.from;
    }
}

const std::vector<Covered>& LatticeCover::row(std::int64_t row) {
    std::fill(cells_.begin(), cells_.end(), Covered{});
    const Band band{static_cast<double>(row) * spacing_, static_cast<double>(row + 1) * spacing_};
    enter_row(band.from, band.to);
    if (parts_are_apart_ && too_many_strips(band)) {
        cover_along_edges(band);
    } else {
        cover_by_strips(strip_heights(band));
    }
    return cells_;
}

// Fraction of a lattice cell's area: at the edge of the material at rest a smaller particle is ejected by the surface
// slope at its only node.
constexpr double k_sliver = 1e-5;
// Fraction of the filled volume: an outline with more than this in slivers consists of little else, like that of a
// line.
constexpr double k_spread = 1e-4;

}  // namespace

void spread_slivers(std::size_t first, double spacing, ParticleSet& particles) {
    const auto is_sliver = [&](std::size_t p) { return particles[Field::area][p] < k_sliver * spacing * spacing; };
    struct Sums {
        double area = 0, volume = 0;
    } slivers, rest;
    for (std::size_t p = first; p < particles.size(); ++p) {
        Sums& of = is_sliver(p) ? slivers : rest;
        of.area += particles[Field::area][p];
        of.volume += particles[Field::volume][p];
    }
    if (slivers.area == 0 || slivers.area > k_spread * rest.area || slivers.volume > k_spread * rest.volume) return;
    std::size_t kept = first;
    for (std::size_t p = first; p < particles.size(); ++p) {
        if (is_sliver(p)) continue;
        ParticleRow row = particles.row(p);
        get(row, Field::area) *= 1 + slivers.area / rest.area;
        get(row, Field::volume) *= 1 + slivers.volume / rest.volume;
        particles.set_row(kept++, row);
    }
    particles.resize(kept);
}

double fill_outline(const MultiPolygon& outline, double spacing, const std::function<double(Point)>& thickness,
                    ParticleSet& particles) {
    LatticeCover cover(outline, spacing);
    const std::size_t first = particles.size();
    double volume = 0;
    for (std::int64_t row = cover.first_row(); row <= cover.last_row(); ++row) {
        for (const Covered& cell : cover.row(row)) {
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
    spread_slivers(first, spacing, particles);
    return volume;
}

}  // namespace frana
