// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "simulation/arrivals.h"
#include "simulation/flow.h"
#include "simulation/particle_table.h"
#include "simulation/recorder.h"
#include "simulation/release.h"
#include "simulation/step_figures.h"
#include "simulation/stopping.h"
#include "simulation/structured_flow.h"
#include "simulation/terms.h"

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

StepFigures figures_of(const voellmy_bingham::StepReport& report) {
    StepFigures f;
    f.dt = report.dt;
    f.volume = report.particles.volume;
    f.max_depth = report.nodes.max_depth;
    f.max_speed = report.nodes.max_speed;
    f.front_distance = std::sqrt(report.particles.front_squared);
    f.kinetic = report.particles.kinetic;
    f.moving = report.nodes.moving;
    f.covered = report.nodes.covered;
    f.unsupported = report.nodes.unsupported;
    f.non_finite = report.particles.non_finite;
    f.clamped = report.particles.clamped;
    f.no_data = report.particles.no_data;
    return f;
}

StepFigures figures_of(const StepFigures& figures) {
    return figures;
}

template <class AnyFlow>
SeriesRow series_row(const AnyFlow& flow, const StepFigures& figures, double density, double entered) {
    SeriesRow row;
    row.time = flow.time();
    row.step = flow.steps();
    row.dt = figures.dt;
    row.volume = figures.volume;
    row.volume_left = flow.volume_left();
    row.volume_entered = entered;
    row.max_depth = figures.max_depth;
    row.max_speed = figures.max_speed;
    row.front_distance = figures.front_distance;
    row.kinetic_energy = density * figures.kinetic;
    row.covered_area =
        static_cast<double>(figures.covered) * flow.nodes().cell_size() * flow.nodes().cell_size();
    return row;
}

// From where the front is measured: the centroid of everything released, else the middle of the first inflow.
Point origin_of(const Release& release, const Arrivals& arrivals) {
    return release.volume > 0 ? release.centroid : arrivals.sources().front().midpoint();
}

void note_scaling(const std::vector<ReleasedArea>& areas, std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (std::abs(areas[i].scaled - 1) <= 1e-9) continue;
        char text[128];
        std::snprintf(text, sizeof text,
                      "thickness of release area %zu scaled by %.4f to hold the given volume", i + 1,
                      areas[i].scaled);
        notes.emplace_back(text);
    }
}

// What a model shows besides depth and speed.
std::vector<NamedRaster> more_of(const Flow&) {
    return {};
}

std::vector<NamedRaster> more_of(const StructuredFlow& flow) {
    return flow.phases();
}

// Of fluid alone the frame's depth and velocity say it all.
template <class AnyFlow>
bool frames_show_more(const AnyFlow& flow) {
    return flow.particle_count() > 0;
}

template <class AnyFlow>
Frame take_frame(AnyFlow& flow, int index, bool with_particles) {
    flow.synchronise();
    auto shot = flow.snapshot();
    return {index, flow.time(), std::move(shot.depth), std::move(shot.speed),
            frames_show_more(flow) ? more_of(flow) : std::vector<NamedRaster>{},
            with_particles ? particle_table(flow) : PointTable{}};
}

// A wall's cell holds nothing, though the nodes there gather a share of what leans against it.
void hide_walls(const Scene& scene, Raster& raster) {
    if (!scene.walls) return;
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        if (scene.walls->values[i] == 1) raster.values[i] = k_no_data;
    }
}

Raster pressure_kpa(const Raster& speed, double density) {
    Raster pressure = speed;
    for (double& value : pressure.values) value = density * value * value / 1000;
    return pressure;
}

double density_of(const Scene& scene, const Flow&) {
    return scene.material.density;
}

double density_of(const Scene&, const StructuredFlow& flow) {
    return flow.density();
}

// What comes later: whole columns that fail, and what flows in, which in the structured model is fluid.
void add_arrivals(const Arrivals::Taken& taken, Flow& flow) {
    flow.add_particles(taken.particles);
}

void add_arrivals(const Arrivals::Taken& taken, StructuredFlow& flow) {
    flow.add_release(taken.failed);
    ParticleSet inflow;
    for (std::size_t p = taken.failed.size(); p < taken.particles.size(); ++p)
        inflow.push_back(taken.particles.row(p));
    flow.add_fluid(inflow);
}

void give_exchanges(const Scene& scene, const Flow& flow, RunResult& result) {
    result.exchanges = scene.entrainment.active();
    if (!result.exchanges) return;
    result.eroded_depth = flow.eroded_depth();
    result.deposited_depth = flow.deposited_depth();
    result.volume_eroded = flow.exchanged().eroded;
    result.volume_deposited = flow.exchanged().deposited;
    result.momentum_deposited =
        scene.material.density * std::hypot(flow.exchanged().momentum_x, flow.exchanged().momentum_y);
}

void give_exchanges(const Scene&, const StructuredFlow&, RunResult&) {}  // its bed stays as it is

// Runs a flow to the scene's end.
template <class AnyFlow>
RunResult run_flow(const Scene& scene, const RunOptions& options, Release& release, Arrivals& arrivals,
                   AnyFlow& flow, Stopwatch& engine) {
    flow.set_origin(origin_of(release, arrivals));
    flow.set_moving_speed(scene.time.moving_speed);
    RunResult result;
    result.terms = list_terms(scene);
    result.particles_initial = result.particles_peak = flow.particle_count();
    result.volume_initial = result.volume_entered = flow.volume();
    result.released = release.areas;
    for (ReleasedArea& area : result.released) area.failed = !(area.start > 0);
    note_scaling(release.areas, result.notes);
    const auto receive = [&] {
        const Arrivals::Taken taken = arrivals.take(flow.time());
        if (scene.terrain_contains_release && taken.failed.size() > 0)
            flow.lower_bed(cell_depth(taken.failed, scene.grid));
        add_arrivals(taken, flow);
        result.volume_inflow += taken.inflow;
        result.volume_entered += taken.inflow;
        for (const std::size_t i : taken.areas) {
            result.released[i].failed = true;
            result.volume_entered += result.released[i].volume;
        }
    };

    const double interval = scene.time.frame_interval;
    int frame = 0;
    const auto give_frame = [&] {
        if (!options.on_frame || interval <= 0) return;
        engine.stop();
        Frame taken = take_frame(flow, frame++, options.particles_in_frames);
        hide_walls(scene, taken.depth);
        hide_walls(scene, taken.velocity);
        options.on_frame(taken);
        engine.start();
    };
    give_frame();
    double next_frame = interval > 0 ? interval : std::numeric_limits<double>::infinity();
    StillWatch watch;
    FadeWatch fade(scene.time);
    Recorder recorder(scene.recording, scene.grid, scene.numerics);
    if (AnyFlow::k_shows_end && !recorder.idle()) recorder.see(flow, 0, 0);
    result.stop_reason = StopReason::end_time;
    while (flow.time() < scene.time.end) {
        const double target = std::min({next_frame, scene.time.end, arrivals.next_time()});
        const double left = target - flow.time();
        // Two equal steps rather than a full one and a sliver.
        const double stable = flow.stable_step();
        const double limit = left <= stable ? left : left < 2 * stable ? 0.5 * left : left;
        const double began = flow.time();
        const StepFigures report = figures_of(flow.advance(limit));
        if (!recorder.idle()) recorder.see(flow, AnyFlow::k_shows_end ? flow.time() : began, report.dt);
        result.series.push_back(series_row(flow, report, density_of(scene, flow), result.volume_entered));
        result.particles_peak = std::max(result.particles_peak, flow.particle_count());
        result.hard_events.non_finite += report.non_finite;
        result.hard_events.depth_clamped += report.clamped;
        result.unsupported += report.unsupported;
        if (scene.numerics.nodata == NodataPolicy::stop) result.hard_events.entered_no_data += report.no_data;
        if (target - flow.time() <= 1e-9 * target) {
            flow.set_time(target);
            if (arrivals.next_time() <= target) receive();
            if (next_frame <= target) {
                if (target < scene.time.end) give_frame();
                next_frame = interval * (std::floor(flow.time() / interval + 1e-6) + 1);
            }
        }
        if (options.on_progress) {
            options.on_progress({flow.steps(), flow.time(), scene.time.end, flow.particle_count()});
        }
        if (report.non_finite > 0) {
            result.stop_reason = StopReason::non_finite;
        } else if (result.hard_events.entered_no_data > 0) {
            result.stop_reason = StopReason::reached_no_data;
        } else if (flow.empty() && arrivals.done()) {
            result.stop_reason = StopReason::all_left;
        } else if (scene.time.stop_when_still && arrivals.done() &&
                   watch.still(report.max_speed, report.dt)) {
            result.stop_reason = StopReason::still;
        } else if (arrivals.done() && fade.energy(report.kinetic)) {
            result.stop_reason = StopReason::energy;
        } else if (arrivals.done() && fade.moving(report.moving)) {
            result.stop_reason = StopReason::moving_volume;
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
    result.more = more_of(flow);
    // A cell that was reached but never moved has speed zero, not "no data".
    for (std::size_t i = 0; i < result.max_depth.values.size(); ++i) {
        if (!std::isnan(result.max_depth.values[i]) && std::isnan(result.max_velocity.values[i])) {
            result.max_velocity.values[i] = 0;
        }
    }
    for (Raster* raster :
         {&result.max_depth, &result.max_velocity, &result.arrival_time, &result.final_depth})
        hide_walls(scene, *raster);
    for (NamedRaster& raster : result.more) hide_walls(scene, raster.values);
    recorder.give(flow, result);
    result.max_pressure = pressure_kpa(result.max_velocity, density_of(scene, flow));
    result.bed = std::move(release.bed);
    result.release = std::move(release.depth);
    result.steps = flow.steps();
    result.simulated_seconds = flow.time();
    result.particles_final = flow.particle_count();
    result.particle_steps = flow.particle_steps();
    result.bytes_per_particle = static_cast<std::int64_t>(flow.bytes_per_particle());
    result.bytes_per_node = static_cast<std::int64_t>(flow.bytes_per_node());
    result.volume_final = flow.volume();
    result.volume_left = flow.volume_left();
    if (!arrivals.done())
        result.notes.emplace_back("the run ended before everything had failed or flowed in");
    give_exchanges(scene, flow, result);
    engine.stop();
    result.engine_seconds = engine.seconds();
    return result;
}

// How long a flow's first steps take and what it holds, with all that comes later on the ground at once: the
// trial steps then cost what the fullest would.
template <class AnyFlow>
void estimate_flow(const Scene& scene, const Arrivals::Taken& rest, AnyFlow& flow, RunEstimate& e) {
    add_arrivals(rest, flow);
    e.first_step_seconds = flow.stable_step();
    // Rasters: terrain, bed, release and five results as doubles; nodes only where material may come, taken
    // as all.
    const std::int64_t cells = scene.grid.cell_count();
    constexpr std::int64_t k_rasters = 10;
    e.bytes_per_particle = static_cast<std::int64_t>(flow.bytes_per_particle());
    e.bytes_per_node = static_cast<std::int64_t>(flow.bytes_per_node());
    e.memory_bytes = cells * (k_rasters * static_cast<std::int64_t>(sizeof(double)) + e.bytes_per_node) +
                     RunEstimate::k_particle_copies * e.particles * e.bytes_per_particle;
    // Time of the first steps, for as many steps as the end time would take at the first step's length.
    constexpr int k_trial_steps = 3;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < k_trial_steps; ++i) flow.advance(scene.time.end);
    const double per_step =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / k_trial_steps;
    e.wall_seconds = per_step * scene.time.end / e.first_step_seconds;
}

}  // namespace

double relative_volume_error(const RunResult& result) {
    const double taken = result.volume_entered + result.volume_eroded;
    if (taken == 0) return 0;
    return std::abs(result.volume_final + result.volume_left + result.volume_deposited - taken) / taken;
}

const char* describe(StopReason reason) {
    switch (reason) {
        case StopReason::end_time:
            return "end time reached";
        case StopReason::still:
            return "everything at rest";
        case StopReason::energy:
            return "kinetic energy under the given share of its peak";
        case StopReason::moving_volume:
            return "moving volume under the given share of its peak";
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
    Arrivals arrivals(scene, std::exchange(release.later, {}));
    if (scene.structured) {
        StructuredFlow flow(release.bed_at_start, scene.walls, *scene.structured, scene.numerics,
                            std::exchange(release.particles, ParticleSet()), options.threads);
        return run_flow(scene, options, release, arrivals, flow, engine);
    }
    Flow flow(release.bed_at_start, std::exchange(release.particles, ParticleSet()), scene.material,
              scene.numerics, options.threads, std::nullopt, scene.zones, scene.entrainment);
    if (scene.walls) flow.add_walls(*scene.walls);
    return run_flow(scene, options, release, arrivals, flow, engine);
}

RunEstimate estimate(const Scene& scene, int threads) {
    Release release = make_release(scene);
    Arrivals arrivals(scene, std::exchange(release.later, {}));
    RunEstimate e;
    e.volume = release.volume;
    e.terms = list_terms(scene);
    const std::size_t arriving = arrivals.particles_left();
    const Arrivals::Taken rest = arrivals.take(scene.time.end);
    e.inflow = rest.inflow;
    if (scene.structured) {
        StructuredFlow flow(release.bed, scene.walls, *scene.structured, scene.numerics, release.particles,
                            threads);
        const std::size_t solids = scene.structured->solids ? rest.failed.size() : 0;
        e.particles = flow.particle_count() + static_cast<std::int64_t>(solids);
        estimate_flow(scene, rest, flow, e);
        return e;
    }
    Flow flow(release.bed, release.particles, scene.material, scene.numerics, threads, std::nullopt,
              scene.zones, scene.entrainment);
    if (scene.walls) flow.add_walls(*scene.walls);
    e.particles = static_cast<std::int64_t>(flow.particles().size() + arriving);
    estimate_flow(scene, rest, flow, e);
    return e;
}

}  // namespace frana
