// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include "simulation/arrivals.h"
#include "simulation/model.h"
#include "simulation/recorder.h"
#include "simulation/release.h"
#include "simulation/result.h"
#include "simulation/run_check.h"
#include "simulation/scene.h"

namespace frana {

/// Determines when the main results have stopped changing: the run-out, the area covered above the trace threshold, and
/// the distribution of the volume. They are sampled at intervals, always after the same steps, and compared with their
/// values one window earlier. The window is a quarter of the time since the last release or inflow: what fades as
/// 1 / time still changes by three times as much as in the window, so that each limit is a third of the error that is
/// allowed (k_to_come). Of the deposit that is what shifting it by a cell would change. Values cannot settle before
/// the kinetic energy has fallen well below its peak: a mass that only begins to move changes little.
class SettlingWatch {
  public:
    SettlingWatch(const TimeControl& time, const GridSpec& grid, const FrontOrigins& origins);

    /// Restarts the window at this time [s], at which material entered.
    void restart(double time);
    /// Called after a step. Returns whether the values have settled.
    /// @param kinetic energy over density [m5/s2]
    /// @param all volume that entered or was eroded so far [m3]
    bool settled(const Model& model, double kinetic, double all);
    /// Their changes over the last window; none before the first window is complete.
    [[nodiscard]] std::optional<Settling> last() const {
        return last_.window > 0 ? std::optional(last_) : std::nullopt;
    }

    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [time, grid, origins, since, next, peak, samples, last] = *this;
        archive(since, next, peak, samples, last.window, last.runout, last.area, last.front_is_final, last.deposit,
                last.deposit_error);
    }

  private:
    struct Lying {
        std::uint64_t node = 0;
        double depth = 0;  ///< volume over cell area [m]

        template <class Archive>
        void serialise(Archive& archive) {
            auto& [place, height] = *this;
            archive(place, height);
        }
    };
    struct Sample {
        double time = 0;
        double runout = 0;         ///< farthest cell of the trace from the nearest origin, in map view [m]
        double area = 0;           ///< of the trace [m2]
        std::vector<Lying> lying;  ///< by node

        template <class Archive>
        void serialise(Archive& archive) {
            auto& [t, far, covered, deposit] = *this;
            archive(t, far, covered, deposit);
        }
    };

    [[nodiscard]] Sample sample(const Model& model) const;
    static double moved(const std::vector<Lying>& from, const std::vector<Lying>& to);
    static double moved_by_a_cell(const std::vector<Lying>& lying, std::uint64_t stride);

    const TimeControl& time_;
    const GridSpec& grid_;
    const FrontOrigins& origins_;
    double since_ = 0;             // time of the last entry [s]
    double next_ = 0;              // next sample [s]
    double peak_ = 0;              // of kinetic energy over density [m5/s2]
    std::vector<Sample> samples_;  // of the last window
    Settling last_;                // window 0: none
};

/// Checks that a flow gains no energy by numerical errors. Motion under gravity and friction alone conserves
///
///     E = kinetic energy along the bed + potential energy + energy dissipated by friction so far;
///
/// numerical errors may dissipate, never add. error() is the greatest rise of E over an earlier value, relative to the
/// greatest kinetic energy plus the dissipation by then, which is the work of gravity. Velocities lag half a step
/// behind positions: a step's kinetic energy is the mean of before and after, and half of its dissipation is counted
/// before. Steps between which volume entered or left (release, inflow, open edges, erosion) are excluded.
///
/// The potential energy of a flow along a slope is that of its pressure, g h^2 / 2n; that of one that ponds has the
/// whole height. Where a thick pile changes from one to the other, its counted energy changes by the difference, g h^2
/// / 2 (1 - 1/n), though nothing moved. So E is counted in three ways, as the flow ponds at the time, as if it never
/// did and as if it always did: an error of the computation raises all three.
class EnergyWatch {
  public:
    void add(const StepStatistics& statistics) {
        if (std::isnan(statistics.energy)) return;
        const double volume = statistics.energy_volume, half = 0.5 * statistics.energy_dissipated;
        const double energies[] = {statistics.energy, statistics.energy - statistics.energy_levelled,
                                   statistics.energy + statistics.energy_sloping};
        const bool same = known_ && std::abs(volume - volume_) <= k_same_volume * volume_;
        for (std::size_t i = 0; i < std::size(counts_); ++i) {
            Count& count = counts_[i];
            if (same) count.balance += energies[i] - count.energy + half_dissipated_ + half;
            count.lowest = std::min(count.lowest, count.balance);
            count.rise = std::max(count.rise, count.balance - count.lowest);
            count.energy = energies[i];
        }
        dissipated_ += statistics.energy_dissipated;
        turned_over_ = std::max(turned_over_, statistics.energy_moving + dissipated_);
        greatest_volume_ = std::max(greatest_volume_, volume);
        half_dissipated_ = half;
        volume_ = volume;
        known_ = true;
    }
    /// None if nothing moved, or hardly (all work of gravity would give the whole flow less than k_negligible: of a
    /// pile that settles, a fraction of almost nothing), or if the model does not report energy.
    [[nodiscard]] std::optional<double> error() const {
        if (!(turned_over_ > 0.5 * greatest_volume_ * k_negligible * k_negligible)) return std::nullopt;
        const auto less = [](const Count& a, const Count& b) { return a.rise < b.rise; };
        return std::min_element(std::begin(counts_), std::end(counts_), less)->rise / turned_over_;
    }

    template <class Archive>
    void serialise(Archive& archive) {
        auto& [known, half, volume, counts, dissipated, turned, greatest] = *this;
        archive(known, half, volume, dissipated, turned, greatest);
        for (Count& count : counts) archive(count.energy, count.balance, count.lowest, count.rise);
    }

  private:
    static constexpr double k_same_volume = 1e-9;  ///< thousand times the rounding of the sums, less than any particle
    static constexpr double k_negligible = 3;      ///< [m/s]: a mean fall of 0.5 m

    /// E, counted in one way [m5/s2].
    struct Count {
        double energy = 0;                         ///< of the previous step
        double balance = 0, lowest = 0, rise = 0;  ///< relative to the start
    };

    bool known_ = false;
    double half_dissipated_ = 0, volume_ = 0;  ///< of the previous step
    Count counts_[3];
    double dissipated_ = 0, turned_over_ = 0, greatest_volume_ = 0;
};

// Conditions that end a run before its end time.

// Determines when a flow has come to rest: at once if nothing moves, otherwise if for some time neither a cell deeper
// than the minimum nor the root of the whole flow's mean squared speed, however thin, exceeded a creep speed (a mass
// that barely overcomes friction exceeds it within that time).
class StillWatch {
  public:
    static constexpr double k_crawl = 0.01;  ///< [m/s]

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
    static constexpr double k_while = 5;  // [s]
    static constexpr int k_frozen_steps = 10;
    int frozen_ = 0;
    double crawling_ = 0;
};

// Determines when a flow's momentum has decreased below a scene's fraction of its peak. It grows from zero, so that a
// flow that has not begun is not ended.
class FadeWatch {
  public:
    explicit FadeWatch(const TimeControl& time) : time_(time) {}

    bool momentum(double now) {
        peak_ = std::max(peak_, now);
        return now < time_.stop_momentum * peak_;
    }
    template <class Archive>
    void serialise(Archive& archive) {
        archive(peak_);
    }

  private:
    const TimeControl& time_;
    double peak_ = 0;
};

/// Measures wall time; can be stopped and restarted.
class Stopwatch {
  public:
    void start() { begin_ = std::chrono::steady_clock::now(); }
    void stop() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
    [[nodiscard]] double seconds() const { return seconds_; }
    /// Transfers the time measured so far; call while stopped.
    template <class Archive>
    void serialise(Archive& archive) {
        archive(seconds_);
    }

  private:
    std::chrono::steady_clock::time_point begin_;
    double seconds_ = 0;
};

/// The run of simulation.h, step by step, with all observations of it. Refers to scene and options.
class SteppedRun {
  public:
    /// Throws as run() does.
    SteppedRun(const Scene& scene, const RunOptions& options);
    SteppedRun(const SteppedRun&) = delete;  // parts refer to each other
    SteppedRun& operator=(const SteppedRun&) = delete;

    /// Whether a step remains to be done.
    [[nodiscard]] bool continues() const { return !stopped_ && model_->time() < scene_.time.end; }
    void step();
    [[nodiscard]] Progress progress() const;
    /// Returns the result; call once.
    RunResult finish();

    /// The whole run, between two steps.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [scene, options, engine, release, arrivals, model, result, stopped, nears_end, frames,
                                next_frame, moved, last_frame, origins, still, fade, settling, recorder, watch,
                                energy] = *this;
        engine.stop();
        archive(engine, arrivals, *model, frames, next_frame, moved, still, fade, settling, recorder, energy);
        archive(result.series, result.particles_peak, result.hard_events, result.unsupported, result.volume_inflow,
                result.volume_entered, result.thin_fraction, result.moving_fraction_limit);
        for (ReleasedArea& area : result.released) archive(area.failed);
        // A stopped run resumes; one that came to rest does not.
        bool ended = stopped && ends_finally(result.stop_reason);
        StopReason reason = result.stop_reason;
        archive(ended, reason);
        if constexpr (Archive::k_reads) {
            archive.require(frames >= 0 && (!ended || ends_finally(reason)));
            stopped = ended;
            if (ended) result.stop_reason = reason;
        }
        std::uint64_t mark = k_end_mark;
        archive(mark);
        if constexpr (Archive::k_reads) archive.require(mark == k_end_mark);
        engine.start();
    }

  private:
    static constexpr std::uint64_t k_end_mark = 0x656e64206f662073;

    void advance();
    void write_frame_now();
    [[nodiscard]] bool follows_motion() const noexcept { return std::isinf(scene_.time.frame_interval); }
    void receive();
    void arrive(double target);
    void count(const StepStatistics& statistics);
    [[nodiscard]] std::optional<StopReason> reason_to_stop(const StepStatistics& statistics);

    const Scene& scene_;
    const RunOptions& options_;
    Stopwatch engine_;  ///< stopped while callbacks run
    Release release_;
    Arrivals arrivals_;
    std::unique_ptr<Model> model_;
    RunResult result_;
    bool stopped_ = false, nears_end_ = false;
    int frames_ = 0;
    double next_frame_;       ///< the first state at or after this time [s], or distance [m], is the next frame
    double moved_ = 0;        ///< root of the flow's mean squared speed, summed over time [m]
    double last_frame_ = -1;  ///< time of the last frame by this process [s]
    FrontOrigins origins_;
    StillWatch still_;
    FadeWatch fade_;
    SettlingWatch settling_;
    Recorder recorder_;
    RunCheck watch_;
    EnergyWatch energy_;
};

}  // namespace frana
