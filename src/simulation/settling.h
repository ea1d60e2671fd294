// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/arrivals.h"
#include "simulation/model.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Determines when the main results have stopped changing: the run-out, the area covered above the trace threshold, and
/// the distribution of the volume. They are sampled at intervals, always after the same steps, and compared with their
/// values one window earlier. The window is a fraction of the time since the last release or inflow, since a
/// decelerating flow changes less and less in the same time, and a steady one does not. Values cannot settle before the
/// kinetic energy has fallen well below its peak: a mass that only begins to move changes little.
class SettlingWatch {
  public:
    SettlingWatch(const TimeControl& time, const GridSpec& grid, const FrontOrigins& origins);

    /// Restarts the window at this time [s], at which material entered.
    void restart(double time);
    /// Called after a step, Returns whether the values have
    /// settled.
    /// @param kinetic energy over density [m5/s2]
    /// @param all volume that entered or was eroded so far [m3]
    bool settled(const Model& model, double kinetic, double all);
    /// Their changes over the last window; none before the first window is complete.
    [[nodiscard]] const std::optional<Settling>& last() const noexcept { return last_; }

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [time, grid, origins, since, next, peak, samples, lying, last] = *this;
        archive(since, next, peak, samples, lying);
        bool there = last.has_value();
        archive(there);
        if (there && !last) last.emplace();
        if (there) archive(last->window, last->runout, last->area, last->front_is_final, last->deposit);
        if constexpr (Archive::k_reads) {
            if (!there) last.reset();
        }
    }

  private:
    struct Sample {
        double time = 0;
        double runout = 0;  ///< farthest cell of the trace from the nearest origin, in map view [m]
        double area = 0;    ///< of the trace [m2]
        double moved = 0;   ///< volume moved to other cells since the previous sample [m3]

        template <class Archive>
        void serialise(Archive& archive) {
            auto& [t, far, covered, volume] = *this;
            archive(t, far, covered, volume);
        }
    };
    struct Lying {
        std::uint64_t node = 0;
        double depth = 0;  ///< volume over cell area [m]

        template <class Archive>
        void serialise(Archive& archive) {
            auto& [place, height] = *this;
            archive(place, height);
        }
    };

    [[nodiscard]] double window(double now) const noexcept;
    [[nodiscard]] Sample sample(const Model& model);

    const TimeControl& time_;
    const GridSpec& grid_;
    const FrontOrigins& origins_;
    double since_ = 0;             // time of the last entry [s]
    double next_ = 0;              // next sample [s]
    double peak_ = 0;              // of kinetic energy over density [m5/s2]
    std::vector<Sample> samples_;  // of the last window and one before it
    std::vector<Lying> lying_;     // at the last sample, by node
    std::optional<Settling> last_;
};

}  // namespace frana
