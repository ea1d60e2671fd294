// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Decides when the values that people use have stopped changing: how far the flow has come, the area that it has
/// covered over the trace threshold, and where its volume lies. They are looked at now and then, always after the same
/// steps, and compared with what they were a window ago: a fraction of the time since the last release or inflow, since
/// a flow that slows down changes less and less in the same time, and one that runs on steadily does not. Nothing
/// settles before its kinetic energy has fallen well below its peak: a mass that only just begins to move changes
/// little.
class SettlingWatch {
  public:
    SettlingWatch(const TimeControl& time, const GridSpec& grid, Point origin);

    /// Something came in at this time [s]: the window begins again.
    void restart(double time);
    /// After a step, in which the flow's nodes hold what they held as it began. Whether the values have settled.
    /// @param kinetic energy over density [m5/s2]
    /// @param all volume that came in or was eroded so far [m3]
    template <class AnyFlow>
    bool settled(const AnyFlow& flow, double kinetic, double all);
    /// How they changed over the last window; none before there was one.
    [[nodiscard]] const std::optional<Settling>& last() const noexcept { return last_; }

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [time, grid, origin, since, next, peak, samples, lying, last] = *this;
        archive(since, next, peak, samples, lying);
        bool there = last.has_value();
        archive(there);
        if (there && !last) last.emplace();
        if (there) archive(last->window, last->runout, last->area, last->deposit);
        if constexpr (Archive::k_reads) {
            if (!there) last.reset();
        }
    }

  private:
    struct Sample {
        double time = 0;
        double runout = 0;  ///< farthest cell of the trace from the origin, in map view [m]
        double area = 0;    ///< of the trace [m2]
        double moved = 0;   ///< volume that lies elsewhere than at the sample before [m3]

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
    template <class AnyFlow>
    [[nodiscard]] Sample sample(const AnyFlow& flow);

    const TimeControl& time_;
    const GridSpec& grid_;
    Point origin_;
    double since_ = 0;             // when something came in last [s]
    double next_ = 0;              // sample [s]
    double peak_ = 0;              // of kinetic energy over density [m5/s2]
    std::vector<Sample> samples_;  // of the last window and one before it
    std::vector<Lying> lying_;     // at the last sample, by node
    std::optional<Settling> last_;
};

}  // namespace frana
