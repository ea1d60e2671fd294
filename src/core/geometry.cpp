// SPDX-License-Identifier: Apache-2.0
#include "core/geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace frana {

double area(const Ring& ring) {
    if (ring.size() < 3) return 0;
    // Relative to the first point: map coordinates of 5e6 m would lose seven digits.
    const Point origin = ring.front();
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Point a{ring[i].x - origin.x, ring[i].y - origin.y};
        const Point b{ring[i + 1].x - origin.x, ring[i + 1].y - origin.y};
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

double area(const Polygon& polygon) {
    double sum = area(polygon.outer);
    for (const Ring& hole : polygon.holes) sum -= area(hole);
    return sum;
}

double area(const MultiPolygon& polygons) {
    double sum = 0;
    for (const Polygon& polygon : polygons) sum += area(polygon);
    return sum;
}

bool contains(const Ring& ring, Point point) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point a = ring[i], b = ring[j];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        const double x = a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (point.x < x) inside = !inside;
    }
    return inside;
}

bool contains(const Polygon& polygon, Point point) {
    if (polygon.outer.empty() || !contains(polygon.outer, point)) return false;
    return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                        [&](const Ring& hole) { return !hole.empty() && contains(hole, point); });
}

bool contains(const MultiPolygon& polygons, Point point) {
    return std::any_of(polygons.begin(), polygons.end(),
                       [&](const Polygon& polygon) { return contains(polygon, point); });
}

Bounds bounds(const MultiPolygon& polygons) {
    Bounds box;
    bool first = true;
    for (const Polygon& polygon : polygons) {
        for (const Point& p : polygon.outer) {
            if (first) box = {p.x, p.y, p.x, p.y};
            first = false;
            box = {std::min(box.west, p.x), std::min(box.south, p.y), std::max(box.east, p.x),
                   std::max(box.north, p.y)};
        }
    }
    return box;
}

std::string extent_text(const Bounds& bounds, bool degrees) {
    char text[200];
    const int decimals = degrees ? 7 : 2;
    std::snprintf(text, sizeof text, "west %.*f, south %.*f, east %.*f, north %.*f", decimals, bounds.west, decimals,
                  bounds.south, decimals, bounds.east, decimals, bounds.north);
    return text;
}

InsideTest::InsideTest(const MultiPolygon& polygons) {
    const auto add = [&](const Ring& ring, std::size_t polygon, std::size_t number) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            if (ring[i].y != ring[j].y)
                edges_.push_back(
                    {ring[i], ring[j], static_cast<std::uint32_t>(polygon), static_cast<std::uint32_t>(number)});
        }
    };
    for (std::size_t p = 0; p < polygons.size(); ++p) {
        if (polygons[p].outer.empty()) continue;
        add(polygons[p].outer, p, 0);
        for (std::size_t h = 0; h < polygons[p].holes.size(); ++h)
            if (!polygons[p].holes[h].empty()) add(polygons[p].holes[h], p, h + 1);
    }
    if (edges_.empty()) return;
    double heights = 0;
    south_ = north_ = edges_.front().a.y;
    for (const Edge& e : edges_) {
        south_ = std::min({south_, e.a.y, e.b.y});
        north_ = std::max({north_, e.a.y, e.b.y});
        heights += std::abs(e.a.y - e.b.y);
    }
    // As many bands as edges, but few enough that an edge is in eight of them on average at most.
    const double n = static_cast<double>(edges_.size());
    const auto bands = static_cast<std::size_t>(std::max(1.0, std::min(n, 7 * n * (north_ - south_) / heights)));
    height_ = (north_ - south_) / static_cast<double>(bands);
    begins_.assign(bands + 1, 0);
    const auto each_band = [&](const auto& visit) {
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const std::size_t last = band(std::max(edges_[e].a.y, edges_[e].b.y));
            for (std::size_t k = band(std::min(edges_[e].a.y, edges_[e].b.y)); k <= last; ++k) visit(k, e);
        }
    };
    each_band([&](std::size_t k, std::size_t) { ++begins_[k + 1]; });
    for (std::size_t k = 0; k < bands; ++k) begins_[k + 1] += begins_[k];
    listed_.resize(begins_.back());
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    each_band([&](std::size_t k, std::size_t e) { listed_[next[k]++] = static_cast<std::uint32_t>(e); });
}

std::size_t InsideTest::band(double y) const {
    const double k = std::floor((y - south_) / height_);
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(begins_.size() - 2)));
}

bool InsideTest::operator()(Point point) const {
    if (edges_.empty() || !(point.y >= south_ && point.y <= north_)) return false;
    const std::size_t k = band(point.y);
    bool in_outer = false, in_hole = false, in_ring = false;
    std::uint32_t polygon = 0, ring = 0;
    const auto end_ring = [&] {
        if (ring == 0) {
            in_outer = in_ring;
        } else {
            in_hole = in_hole || in_ring;
        }
        in_ring = false;
    };
    for (std::size_t i = begins_[k]; i < begins_[k + 1]; ++i) {
        const Edge& e = edges_[listed_[i]];
        if (e.polygon != polygon || e.ring != ring) {
            end_ring();
            ring = e.ring;
            if (e.polygon != polygon) {
                if (in_outer && !in_hole) return true;
                in_outer = in_hole = false;
                polygon = e.polygon;
            }
        }
        if ((e.a.y > point.y) == (e.b.y > point.y)) continue;
        const double x = e.a.x + (point.y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x);
        if (point.x < x) in_ring = !in_ring;
    }
    end_ring();
    return in_outer && !in_hole;
}

namespace {

constexpr std::size_t k_leaf = 8;
// Margin of the boxes: rounding may bring a segment slightly nearer than its box [m].
constexpr double k_rounding = 1e-6;

double square_to(const Segment& s, Point point) {
    const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
    const double px = point.x - s.from.x, py = point.y - s.from.y;
    const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double ex = px - t * dx, ey = py - t * dy;
    return ex * ex + ey * ey;
}

double square_to(const Bounds& box, Point point) {
    const double dx = std::max({box.west - point.x, 0.0, point.x - box.east}),
                 dy = std::max({box.south - point.y, 0.0, point.y - box.north});
    return dx * dx + dy * dy;
}

}  // namespace

NearestSegment::NearestSegment(std::vector<Segment> segments) : segments_(std::move(segments)) {
    if (!segments_.empty()) build(0, segments_.size());
}

std::size_t NearestSegment::build(std::size_t first, std::size_t last) {
    constexpr double k_far = std::numeric_limits<double>::infinity();
    Bounds box{k_far, k_far, -k_far, -k_far};
    for (std::size_t i = first; i < last; ++i) {
        const auto [a, b] = segments_[i];
        box = {std::min({box.west, a.x, b.x}), std::min({box.south, a.y, b.y}), std::max({box.east, a.x, b.x}),
               std::max({box.north, a.y, b.y})};
    }
    box = {box.west - k_rounding, box.south - k_rounding, box.east + k_rounding, box.north + k_rounding};
    const std::size_t self = boxes_.size();
    boxes_.push_back({box, first, last, {}});
    if (last - first <= k_leaf) return self;
    const bool wide = box.width() > box.height();
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return segments_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](const Segment& a, const Segment& b) {
        return wide ? a.from.x + a.to.x < b.from.x + b.to.x : a.from.y + a.to.y < b.from.y + b.to.y;
    });
    const std::size_t one = build(first, middle), other = build(middle, last);
    boxes_[self].halves = {one, other};
    return self;
}

void NearestSegment::search(std::size_t self, Point point, double& nearest) const {
    const Box& box = boxes_[self];
    if (box.halves[1] == 0) {
        for (std::size_t i = box.first; i < box.last; ++i) nearest = std::min(nearest, square_to(segments_[i], point));
        return;
    }
    std::array<std::pair<double, std::size_t>, 2> halves;
    for (std::size_t k = 0; k < 2; ++k) halves[k] = {square_to(boxes_[box.halves[k]].bounds, point), box.halves[k]};
    if (halves[1].first < halves[0].first) std::swap(halves[0], halves[1]);
    for (const auto& [square, half] : halves)
        if (square <= nearest) search(half, point, nearest);
}

double NearestSegment::square_of_distance(Point point) const {
    double nearest = std::numeric_limits<double>::infinity();
    if (!boxes_.empty()) search(0, point, nearest);
    return nearest;
}

}  // namespace frana
