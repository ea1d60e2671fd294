// SPDX-License-Identifier: Apache-2.0
// Conditions that end a run before its end time.
#pragma once

#include <algorithm>
#include <cmath>

#include "simulation/scene.h"
#include "simulation/step_statistics.h"

namespace frana {

// Determines when a flow has come to rest: at once if nothing moves, otherwise if for some time neither a cell deeper
// than the minimum nor the root of the whole flow's mean squared speed, however thin, exceeded a creep speed (a mass
// that barely overcomes friction exceeds it within that time).
class StillWatch {
  public:
    bool still(const StepStatistics& now) {
        const double mean = now.volume > 0 ? std::sqrt(2 * now.kinetic / now.volume) : 0;
        const double speed = std::max(now.max_speed, mean);
        frozen_ = speed > 0 ? 0 : frozen_ + 1;
        crawling_ = speed > k_crawl ? 0 : crawling_ + now.dt;
        return frozen_ >= k_frozen_steps || crawling_ >= k_while;
    }
    template <class Archive>
    void serialise(Archive& archive) {
        auto& [frozen, crawling] = *this;
        archive(frozen, crawling);
    }

  private:
    static constexpr double k_crawl = 0.01;  // [m/s]
    static constexpr double k_while = 5;     // [s]
    static constexpr int k_frozen_steps = 10;
    int frozen_ = 0;
    double crawling_ = 0;
};

// Determines when a flow's motion has decreased below a scene's limit: kinetic energy, moving volume or momentum below
// a fraction of its peak. All grow from zero, so none ends a flow that has not begun.
class FadeWatch {
  public:
    explicit FadeWatch(const TimeControl& time) : time_(time) {}

    bool energy(double now) { return under(now, energy_peak_, time_.stop_energy_fraction); }
    bool moving(double now) { return under(now, moving_peak_, time_.stop_moving_fraction); }
    bool momentum(double now) { return under(now, momentum_peak_, time_.stop_momentum); }
    template <class Archive>
    void serialise(Archive& archive) {
        archive(energy_peak_, moving_peak_, momentum_peak_);
    }

  private:
    static bool under(double now, double& peak, double fraction) {
        peak = std::max(peak, now);
        return now < fraction * peak;
    }
    const TimeControl& time_;
    double energy_peak_ = 0, moving_peak_ = 0, momentum_peak_ = 0;
};

}  // namespace frana
