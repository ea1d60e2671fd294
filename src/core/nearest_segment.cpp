// SPDX-License-Identifier: Apache-2.0
#include "core/nearest_segment.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace frana {
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
