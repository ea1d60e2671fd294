// SPDX-License-Identifier: Apache-2.0
#include "core/geometry.h"

#include <algorithm>
#include <cmath>

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

}  // namespace frana
