// SPDX-License-Identifier: Apache-2.0
#include "simulation/arrivals.h"

#include <algorithm>
#include <cmath>

#include "analysis/separate_flows.h"

namespace frana {

Arrivals::Arrivals(const Scene& scene, std::vector<Entry> later) : later_(std::move(later)) {
    for (const Inflow& inflow : scene.inflows) sources_.emplace_back(scene, inflow);
}

double Arrivals::next_time() const {
    double time = std::numeric_limits<double>::infinity();
    if (next_entry_ < later_.size()) time = later_[next_entry_].time;
    for (const InflowSource& source : sources_) {
        if (!source.done()) time = std::min(time, source.next_time());
    }
    return time;
}

Arrivals::Arrived Arrivals::collect(double time) {
    Arrived arrived;
    for (; next_entry_ < later_.size() && later_[next_entry_].time <= time; ++next_entry_) {
        Entry& entry = later_[next_entry_];
        for (std::size_t p = 0; p < entry.particles.size(); ++p) {
            arrived.particles.push_back(entry.particles.row(p));
            arrived.failed.push_back(entry.particles.row(p));
        }
        arrived.areas.insert(arrived.areas.end(), entry.areas.begin(), entry.areas.end());
        entry.particles = ParticleSet();
    }
    for (InflowSource& source : sources_) {
        while (!source.done() && source.next_time() <= time) arrived.inflow += source.emit(arrived.particles);
    }
    return arrived;
}

std::size_t Arrivals::particles_left() const {
    std::size_t count = 0;
    for (std::size_t i = next_entry_; i < later_.size(); ++i) count += later_[i].particles.size();
    for (const InflowSource& source : sources_) count += source.particles_left();
    return count;
}

namespace {

constexpr double k_least_volume = 0.01;  // of the greatest release

struct Group {
    double volume = 0, x = 0, y = 0;  // sums over its cells
};

std::vector<Group> groups_of(const Raster& depth) {
    const SeparateFlows releases(depth, depth);
    std::vector<Group> groups(releases.count());
    const GridSpec& grid = depth.grid;
    depth.values.for_each_stored([&](std::size_t cell, double metres) {
        if (!(metres > 0)) return;
        const auto n = static_cast<std::int64_t>(cell);
        const Point at = grid.local_from_map(grid.cell_centre(n / grid.columns, n % grid.columns));
        Group& group = groups[releases.flow_of(cell)];
        group.volume += metres;
        group.x += metres * at.x;
        group.y += metres * at.y;
    });
    return groups;
}

}  // namespace

FrontOrigins::FrontOrigins(const Release& release, const Arrivals& arrivals) {
    if (release.volume > 0) {
        const std::vector<Group> groups = groups_of(release.depth);
        double greatest = 0;
        for (const Group& group : groups) greatest = std::max(greatest, group.volume);
        for (const Group& group : groups)
            if (group.volume >= k_least_volume * greatest)
                places_.push_back({group.x / group.volume, group.y / group.volume});
        // The particles' own, where there is one.
        if (places_.size() == 1) places_.front() = release.centroid;
    }
    for (const InflowSource& source : arrivals.sources()) places_.push_back(source.midpoint());
    std::stable_sort(places_.begin(), places_.end(), [](Point a, Point b) { return a.x < b.x; });
}

double FrontOrigins::squared_distance(Point place) const noexcept {
    const auto squared = [&](Point origin) {
        const double x = place.x - origin.x, y = place.y - origin.y;
        return x * x + y * y;
    };
    if (single()) return squared(places_.front());
    const auto too_far = [&](Point origin, double least) {
        const double x = place.x - origin.x;
        return x * x > least;
    };
    auto right =
        std::lower_bound(places_.begin(), places_.end(), place.x, [](Point origin, double x) { return origin.x < x; });
    auto left = right;
    double least = HUGE_VAL;
    for (; right != places_.end() && !too_far(*right, least); ++right) least = std::min(least, squared(*right));
    for (; left != places_.begin() && !too_far(*std::prev(left), least); --left)
        least = std::min(least, squared(*std::prev(left)));
    return least;
}

}  // namespace frana
