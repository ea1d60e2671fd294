// SPDX-License-Identifier: Apache-2.0
#include "simulation/arrivals.h"

#include <algorithm>

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

}  // namespace frana
