// SPDX-License-Identifier: Apache-2.0
#include "simulation/settling.h"

#include <algorithm>
#include <cmath>

namespace frana {
namespace {

constexpr double k_least_window = 10;  // [s]
constexpr double k_samples = 5;        // in a window
constexpr double k_of_deposit = 4;     // limit of the fraction of the volume that moves, in multiples of the limit of
                                       // the area's change
constexpr double k_calm = 0.1;         // fraction of the kinetic energy's peak below which values may settle

}  // namespace

SettlingWatch::SettlingWatch(const TimeControl& time, const GridSpec& grid, const FrontOrigins& origins)
    : time_(time), grid_(grid), origins_(origins) {}

void SettlingWatch::restart(double time) {
    since_ = next_ = time;
    peak_ = 0;
    samples_.clear();
}

double SettlingWatch::window(double now) const noexcept {
    return std::max(k_least_window, time_.stop_window * (now - since_));
}

SettlingWatch::Sample SettlingWatch::sample(const Model& model) {
    Sample sample;
    sample.time = model.time();
    double farthest2 = 0;
    std::int64_t cells = 0;
    const ZeroArray<double>& depth = model.maxima().depth;
    const NodeGrid& nodes = model.nodes();
    nodes.for_each_covered_run([&](std::int64_t j, std::int64_t i0, std::int64_t i1) {
        for (std::int64_t i = i0; i < i1; ++i) {
            if (!(depth[nodes.index(i, j)] >= time_.trace_threshold)) continue;
            ++cells;
            farthest2 = std::max(farthest2, origins_.squared_distance(nodes.middle(i + k_ghost, j + k_ghost)));
        }
    });
    sample.area = static_cast<double>(cells) * grid_.cell_area();
    sample.runout = std::sqrt(farthest2);

    std::vector<Lying> now;
    model.for_each_active_state([&](std::size_t node, const NodeState& state) {
        if (state.volume_depth > 0) now.push_back({node, state.volume_depth});
    });
    std::sort(now.begin(), now.end(), [](const Lying& a, const Lying& b) { return a.node < b.node; });
    // Volume added to one cell was removed from another: half the sum of changes; volume that left the map counts half
    // as well.
    double changed = 0;
    auto a = lying_.begin(), b = now.begin();
    while (a != lying_.end() || b != now.end()) {
        if (b == now.end() || (a != lying_.end() && a->node < b->node)) {
            changed += a++->depth;
        } else if (a == lying_.end() || b->node < a->node) {
            changed += b++->depth;
        } else {
            changed += std::abs(a++->depth - b++->depth);
        }
    }
    sample.moved = 0.5 * changed * grid_.cell_area();
    lying_ = std::move(now);
    return sample;
}

bool SettlingWatch::settled(const Model& model, double kinetic, double all) {
    peak_ = std::max(peak_, kinetic);
    if (!(time_.stop_change > 0) || model.time() < next_) return false;
    const double length = window(model.time());
    next_ = model.time() + length / k_samples;
    samples_.push_back(sample(model));
    const Sample& now = samples_.back();
    // The window's first sample is the last of those that are old enough.
    std::size_t first = 0;
    while (first + 1 < samples_.size() && samples_[first + 1].time <= now.time - length) ++first;
    samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(first));
    if (samples_.front().time > now.time - length) return false;
    Settling change{now.time - samples_.front().time, now.runout - samples_.front().runout,
                    now.area > 0 ? (now.area - samples_.front().area) / now.area : 0, false, 0};
    for (std::size_t i = 1; i < samples_.size(); ++i) change.deposit += samples_[i].moved;
    if (all > 0) change.deposit /= all;
    const double most = time_.stop_change;
    change.front_is_final = now.area > 0 && kinetic < k_calm * peak_ &&
                            change.runout <= std::max(grid_.cell_size, most * now.runout) && change.area <= most;
    last_ = change;
    return change.front_is_final && change.deposit <= k_of_deposit * most;
}

}  // namespace frana
