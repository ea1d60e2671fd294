// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "simulation/dispatch.h"
#include "simulation/flow.h"
#include "simulation/release.h"

namespace frana {
namespace {

class Stopwatch {
  public:
    void start() { begin_ = std::chrono::steady_clock::now(); }
    void stop() {
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
    [[nodiscard]] double seconds() const { return seconds_; }

  private:
    std::chrono::steady_clock::time_point begin_;
    double seconds_ = 0;
};

// Decides when a flow has come to rest: at once when nothing at all moves, otherwise when nothing has moved
// faster than a crawl for a while (a mass that barely overcomes friction is faster than that within the same
// while).
class StillWatch {
  public:
    bool still(double speed, double dt) {
        frozen_ = speed > 0 ? 0 : frozen_ + 1;
        crawling_ = speed > k_crawl ? 0 : crawling_ + dt;
        return frozen_ >= k_frozen_steps || crawling_ >= k_while;
    }

  private:
    static constexpr double k_crawl = 0.01;  // [m/s]
    static constexpr double k_while = 5;     // [s]
    static constexpr int k_frozen_steps = 10;
    int frozen_ = 0;
    double crawling_ = 0;
};

SeriesRow series_row(const Flow& flow, const voellmy_bingham::StepReport& report, double density) {
    SeriesRow row;
    row.time = flow.time();
    row.step = flow.steps();
    row.dt = report.dt;
    row.volume = report.particles.volume;
    row.volume_left = flow.volume_left();
    row.max_depth = report.nodes.max_depth;
    row.max_speed = report.nodes.max_speed;
    row.front_distance = std::sqrt(report.particles.front_squared);
    row.kinetic_energy = density * report.particles.kinetic;
    row.covered_area =
        static_cast<double>(report.nodes.covered) * flow.nodes().cell_size() * flow.nodes().cell_size();
    return row;
}

Frame take_frame(Flow& flow, int index) {
    flow.synchronise();
    Flow::Snapshot shot = flow.snapshot();
    return {index, flow.time(), std::move(shot.depth), std::move(shot.speed)};
}

Raster pressure_kpa(const Raster& speed, double density) {
    Raster pressure = speed;
    for (double& value : pressure.values) value = density * value * value / 1000;
    return pressure;
}

}  // namespace

const char* describe(StopReason reason) {
    switch (reason) {
        case StopReason::end_time:
            return "end time reached";
        case StopReason::still:
            return "everything at rest";
        case StopReason::all_left:
            return "everything has left the domain";
        case StopReason::requested:
            return "stopped by a signal";
        case StopReason::reached_no_data:
            return "the flow reached cells without terrain";
        case StopReason::non_finite:
            return "non-finite values appeared";
    }
    return "";
}

RunResult run(const Scene& scene, const RunOptions& options) {
    Stopwatch engine;
    engine.start();
    Release release = make_release(scene);
    Flow flow(release.bed, release.particles, scene.material, scene.numerics, options.threads);
    RunResult result;
    result.terms = list_terms(scene.material, scene.numerics);
    result.particles_initial = result.particles_peak = static_cast<std::int64_t>(release.particles.size());
    result.volume_initial = flow.volume();
    release.particles = ParticleSet();  // the flow has its own copy
    if (std::abs(release.scaled - 1) > 1e-9) {
        char text[96];
        std::snprintf(text, sizeof text, "release thickness scaled by %.4f to hold the given volume",
                      release.scaled);
        result.notes.emplace_back(text);
    }

    const double interval = scene.time.frame_interval;
    int frame = 0;
    const auto give_frame = [&] {
        if (!options.on_frame || interval <= 0) return;
        engine.stop();
        options.on_frame(take_frame(flow, frame++));
        engine.start();
    };
    give_frame();
    double next_frame = interval > 0 ? interval : scene.time.end;
    StillWatch watch;
    result.stop_reason = StopReason::end_time;
    while (flow.time() < scene.time.end) {
        const double target = std::min(next_frame, scene.time.end);
        const double left = target - flow.time();
        // Two equal steps rather than a full one and a sliver.
        const double stable = flow.stable_step();
        const double limit = left <= stable ? left : left < 2 * stable ? 0.5 * left : left;
        const voellmy_bingham::StepReport report = flow.advance(limit);
        result.series.push_back(series_row(flow, report, scene.material.density));
        result.particles_peak =
            std::max(result.particles_peak, static_cast<std::int64_t>(flow.particles().size()));
        result.hard_events.non_finite += report.particles.non_finite;
        result.hard_events.depth_clamped += report.particles.clamped;
        if (scene.numerics.nodata == NodataPolicy::stop)
            result.hard_events.entered_no_data += report.particles.no_data;
        if (target - flow.time() <= 1e-9 * target) {
            if (target < scene.time.end) give_frame();
            next_frame = interval * (std::floor(flow.time() / interval + 1e-6) + 1);
        }
        if (options.on_progress) {
            options.on_progress({flow.steps(), flow.time(), scene.time.end,
                                 static_cast<std::int64_t>(flow.particles().size())});
        }
        if (report.particles.non_finite > 0) {
            result.stop_reason = StopReason::non_finite;
        } else if (result.hard_events.entered_no_data > 0) {
            result.stop_reason = StopReason::reached_no_data;
        } else if (flow.particles().size() == 0) {
            result.stop_reason = StopReason::all_left;
        } else if (scene.time.stop_when_still && watch.still(report.nodes.max_speed, report.dt)) {
            result.stop_reason = StopReason::still;
        } else if (options.stop_requested && options.stop_requested()) {
            result.stop_reason = StopReason::requested;
        } else {
            continue;
        }
        break;
    }
    flow.synchronise();
    give_frame();
    flow.see_present();
    const Maxima& maxima = flow.maxima();
    result.max_depth = flow.to_raster(maxima.depth);
    result.max_velocity = flow.to_raster(maxima.speed);
    result.arrival_time = flow.to_raster(maxima.arrival_plus_1, 1);
    result.final_depth = flow.snapshot().depth;
    // A cell that was reached but never moved has speed zero, not "no data".
    for (std::size_t i = 0; i < result.max_depth.values.size(); ++i) {
        if (!std::isnan(result.max_depth.values[i]) && std::isnan(result.max_velocity.values[i])) {
            result.max_velocity.values[i] = 0;
        }
    }
    result.max_pressure = pressure_kpa(result.max_velocity, scene.material.density);
    result.bed = std::move(release.bed);
    result.release = std::move(release.depth);
    result.steps = flow.steps();
    result.simulated_seconds = flow.time();
    result.particles_final = static_cast<std::int64_t>(flow.particles().size());
    result.particle_steps = flow.particle_steps();
    result.bytes_per_particle = static_cast<std::int64_t>(flow.particles().bytes_per_particle());
    result.bytes_per_node = static_cast<std::int64_t>(flow.bytes_per_node());
    result.volume_final = flow.volume();
    result.volume_left = flow.volume_left();
    engine.stop();
    result.engine_seconds = engine.seconds();
    return result;
}

RunEstimate estimate(const Scene& scene, int threads) {
    const Release release = make_release(scene);
    Flow flow(release.bed, release.particles, scene.material, scene.numerics, threads);
    RunEstimate e;
    e.particles = static_cast<std::int64_t>(flow.particles().size());
    e.volume = flow.volume();
    e.first_step_seconds = flow.stable_step();
    e.terms = list_terms(scene.material, scene.numerics);
    // Rasters: terrain, bed, release and five results as doubles; nodes only where material may come, taken
    // as all.
    const std::int64_t cells = scene.grid.cell_count();
    constexpr std::int64_t k_rasters = 10;
    e.bytes_per_particle = static_cast<std::int64_t>(flow.particles().bytes_per_particle());
    e.bytes_per_node = static_cast<std::int64_t>(flow.bytes_per_node());
    e.memory_bytes = cells * (k_rasters * static_cast<std::int64_t>(sizeof(double)) + e.bytes_per_node) +
                     3 * e.particles * e.bytes_per_particle;
    // Time of the first steps, for as many steps as the end time would take at the first step's length.
    constexpr int k_trial_steps = 3;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < k_trial_steps; ++i) flow.advance(scene.time.end);
    const double per_step =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / k_trial_steps;
    e.wall_seconds = per_step * scene.time.end / e.first_step_seconds;
    return e;
}

}  // namespace frana
