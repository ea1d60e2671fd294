// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "simulation/arrivals.h"
#include "simulation/energy_watch.h"
#include "simulation/front_origins.h"
#include "simulation/recorder.h"
#include "simulation/release.h"
#include "simulation/result.h"
#include "simulation/run_check.h"
#include "simulation/scene.h"
#include "simulation/settling.h"
#include "simulation/stopping.h"

namespace frana {

class Flow;
class StructuredFlow;

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

/// A flow stepped to a scene's end, with all observations of it. Refers to all its constructor's arguments.
template <class AnyFlow>
class FlowRun {
  public:
    /// @param engine running: stopped while callbacks run
    FlowRun(const Scene& scene, const RunOptions& options, Release& release, Arrivals& arrivals, AnyFlow& flow,
            Stopwatch& engine);

    /// Records the state before the first step.
    void begin();
    /// Whether a step remains to be done.
    [[nodiscard]] bool continues() const { return !stopped_ && flow_.time() < scene_.time.end; }
    void step();
    /// Returns the result; call once.
    RunResult finish();

    [[nodiscard]] Progress progress() const;
    /// The whole run, between two steps.
    template <class Archive>
    void serialise(Archive& archive) {
        [[maybe_unused]] auto& [scene, options, release, arrivals, flow, engine, result, stopped, frames, next_frame,
                                last_frame, origins, still, fade, settling, recorder, watch, energy] = *this;
        engine.stop();
        archive(engine, arrivals, flow, frames, next_frame, still, fade, settling, recorder, energy);
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

    void write_frame_now();
    void receive();
    void arrive(double target);
    void count(const StepStatistics& statistics);
    [[nodiscard]] std::optional<StopReason> reason_to_stop(const StepStatistics& statistics);

    const Scene& scene_;
    const RunOptions& options_;
    Release& release_;
    Arrivals& arrivals_;
    AnyFlow& flow_;
    Stopwatch& engine_;
    RunResult result_;
    bool stopped_ = false;
    int frames_ = 0;
    double next_frame_;       ///< the first state at or after this time is the next frame [s]
    double last_frame_ = -1;  ///< time of the last frame by this process [s]
    FrontOrigins origins_;
    StillWatch still_;
    FadeWatch fade_;
    SettlingWatch settling_;
    Recorder recorder_;
    RunCheck watch_;
    EnergyWatch energy_;
};

/// Adds later arrivals: columns of failed material, and inflow, which in the structured model is fluid.
void add_arrivals(const Arrivals::Arrived& arrived, Flow& flow);
void add_arrivals(const Arrivals::Arrived& arrived, StructuredFlow& flow);

/// Returns the reference point of elevations: the centroid of everything released, else the middle
/// of the first inflow. Local metres.
Point origin_of(const Release& release, const Arrivals& arrivals);

}  // namespace frana
