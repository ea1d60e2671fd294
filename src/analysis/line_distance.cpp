// SPDX-License-Identifier: Apache-2.0
#include "analysis/line_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace frana {
namespace {

bool on_one_line(Point a, Point b, Point c) {
    const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    return along > 0 && std::abs(cross) <= 1e-9 * along;
}

}  // namespace

LineSet::LineSet(const MultiPolygon& area) {
    for (const Polygon& polygon : area) {
        add(polygon.outer, true);
        for (const Ring& hole : polygon.holes) add(hole, true);
    }
    nearest_ = NearestSegment(segments_);
}

LineSet::LineSet(const std::vector<Polyline>& lines) {
    for (const Polyline& line : lines) add(line, false);
    nearest_ = NearestSegment(segments_);
}

void LineSet::add(const Polyline& line, bool closed) {
    const std::size_t first = segments_.size();
    const std::size_t count = line.size() < 2 ? 0 : line.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Point from = line[i], to = line[(i + 1) % line.size()];
        if (from.x == to.x && from.y == to.y) continue;
        if (segments_.size() > first && on_one_line(segments_.back().from, from, to)) {
            segments_.back().to = to;
        } else {
            segments_.push_back({from, to});
        }
    }
}

double LineSet::distance(Point point) const {
    return empty() ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(nearest_.square_of_distance(point));
}

std::vector<Point> LineSet::samples(double spacing) const {
    std::vector<Point> points;
    for (const Segment& s : segments_) {
        const double length = std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
        const auto count = static_cast<std::size_t>(std::ceil(length / spacing));
        for (std::size_t i = 0; i < count; ++i) {
            const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            points.push_back({s.from.x + t * (s.to.x - s.from.x), s.from.y + t * (s.to.y - s.from.y)});
        }
    }
    return points;
}

LineDistance distance_statistics(std::vector<double> distances) {
    for (double& distance : distances) distance = std::abs(distance);
    std::sort(distances.begin(), distances.end());
    double sum = 0;
    for (const double distance : distances) sum += distance;
    const double count = static_cast<double>(distances.size());
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * count)) - 1;
    return {sum / count, distances[rank], distances.back()};
}

LineDistance distance_between(const LineSet& one, const LineSet& other, double spacing) {
    if (one.empty() || other.empty()) {
        throw Error(ErrorKind::input, Problem{"an outline is empty, so its distance from the other is undefined",
                                              "comparison", "", "", "Lower the depth threshold or check the files"});
    }
    std::vector<double> distances;
    for (const Point& point : one.samples(spacing)) distances.push_back(other.distance(point));
    for (const Point& point : other.samples(spacing)) distances.push_back(one.distance(point));
    return distance_statistics(std::move(distances));
}

}  // namespace frana
