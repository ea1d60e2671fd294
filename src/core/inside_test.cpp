// SPDX-License-Identifier: Apache-2.0
#include "core/inside_test.h"

#include <algorithm>
#include <cmath>

namespace frana {

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

}  // namespace frana
