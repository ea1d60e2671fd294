// SPDX-License-Identifier: Apache-2.0
#include "simulation/flow_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "analysis/ground_statistics.h"
#include "core/raster.h"
#include "mpm/node_grid.h"
#include "params/keys/result_rasters.h"
#include "simulation/flow.h"
#include "simulation/particle_table.h"
#include "simulation/release.h"
#include "simulation/scene.h"
#include "simulation/stepped_run.h"
#include "simulation/structured_flow.h"
#include "simulation/terms.h"
#include "simulation/terrain_sample.h"

namespace frana {

// Corrections of the rasters of a run before they are returned.

namespace {

/// A wall's cell contains no material, though the nodes there gather a fraction of particles beside it.
void hide_walls(const Scene& scene, Raster& raster) {
    if (!scene.walls || raster.values.empty()) return;
    scene.walls->values.for_each_stored([&](std::size_t cell, double wall) {
        if (wall == 1 && !std::isnan(std::as_const(raster).values[cell])) raster.values[cell] = k_no_data;
    });
}

/// Returns the dynamic pressure [kPa] of a speed [m/s].
Raster pressure_kpa(const Raster& speed, double density) {
    Raster pressure = speed;
    pressure.values.change_each_stored([&](std::size_t, double& value) { value = density * value * value / 1000; });
    return pressure;
}

/// Removes non-finite values from the maps of a run that ended with some.
void hide_non_finite(Raster& raster) {
    raster.values.change_each_stored([](std::size_t, double& value) {
        if (!std::isfinite(value)) value = k_no_data;
    });
}

/// For terrain read on demand: reads the elevations under all cells that the nodes have covered.
void read_ground_under(const NodeGrid& nodes, const Raster& terrain, const Raster& bed) {
    if (!nodes.is_on_demand()) return;
    nodes.for_each_covered_run([&](std::int64_t j, std::int64_t i0, std::int64_t i1) {
        for (const std::int64_t column : {i0, i1 - 1}) {
            static_cast<void>(bed.at(bed.grid.rows - 1 - j, column));
            static_cast<void>(terrain.at(terrain.grid.rows - 1 - j, column));
        }
    });
}

StepStatistics statistics_of(const voellmy_bingham::StepReport& report) {
    StepStatistics f;
    f.dt = report.dt;
    f.volume = report.particles.volume + report.aloft;
    f.max_depth = report.nodes.max_depth;
    f.max_speed = report.nodes.max_speed;
    f.fastest = report.particles.speed;
    f.front_distance = std::sqrt(report.particles.front_squared);
    f.kinetic = report.particles.kinetic + report.aloft_kinetic;
    f.energy = report.nodes.energy;
    f.energy_moving = report.nodes.kinetic;
    f.energy_volume = report.nodes.volume;
    f.energy_dissipated = report.nodes.dissipated;
    f.moving = report.nodes.moving + report.aloft;
    f.thin = report.nodes.thin;
    f.covered = report.nodes.covered;
    f.unsupported = report.nodes.unsupported;
    f.non_finite = report.particles.non_finite;
    f.clamped = report.particles.clamped;
    f.no_data = report.particles.no_data;
    return f;
}

StepStatistics statistics_of(const StepStatistics& statistics) {
    return statistics;
}

// Volumes eroded from and deposited on the bed so far [m3].
struct BedBudget {
    double eroded = 0, deposited = 0;
};

BedBudget bed_budget(const Flow& flow) {
    return {flow.exchanged().eroded, flow.exchanged().deposited};
}

BedBudget bed_budget(const StructuredFlow&) {
    return {};  // its bed does not change
}

template <class AnyFlow>
SeriesRow series_row(const AnyFlow& flow, const StepStatistics& statistics, double density, const RunResult& so_far) {
    SeriesRow row;
    row.time = flow.time();
    row.step = flow.steps();
    row.dt = statistics.dt;
    row.volume = statistics.volume;
    row.volume_left = flow.volume_left();
    row.volume_entered = so_far.volume_entered;
    row.volume_inflow = so_far.volume_inflow;
    const BedBudget bed = bed_budget(flow);
    row.volume_eroded = bed.eroded;
    row.volume_deposited = bed.deposited;
    row.max_depth = statistics.max_depth;
    row.max_speed = statistics.max_speed;
    row.front_distance = statistics.front_distance;
    row.kinetic_energy = density * statistics.kinetic;
    row.covered_area = static_cast<double>(statistics.covered) * flow.nodes().cell_size() * flow.nodes().cell_size();
    return row;
}

void note_scaling(const std::vector<ReleasedArea>& areas, std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (std::abs(areas[i].scaled - 1) <= 1e-9) continue;
        char text[128];
        std::snprintf(text, sizeof text, "thickness of release area %zu scaled by %.4f to the given volume", i + 1,
                      areas[i].scaled);
        notes.emplace_back(text);
    }
}

// Rasters of a model besides depth and speed.
std::vector<NamedRaster> more_of(const Flow&) {
    return {};
}

std::vector<NamedRaster> more_of(const StructuredFlow& flow) {
    return flow.phases();
}

// For fluid alone the frame's depth and velocity are complete.
template <class AnyFlow>
bool frames_show_more(const AnyFlow& flow) {
    return flow.particle_count() > 0;
}

// Returns the flow in the state after its last step; making a frame does not change it: a Flow's velocities are those
// of its last motion.
template <class AnyFlow>
Frame store_frame(AnyFlow& flow, int index, bool with_particles) {
    auto shot = flow.snapshot();
    return {index,
            flow.time(),
            std::move(shot.depth),
            std::move(shot.speed),
            frames_show_more(flow) ? more_of(flow) : std::vector<NamedRaster>{},
            with_particles ? particle_table(flow) : PointTable{}};
}

double density_of(const Scene& scene, const Flow&) {
    return scene.material.density;
}

double density_of(const Scene&, const StructuredFlow& flow) {
    return flow.density();
}

Raster pressure_of(const Scene& scene, const Flow& flow, const Raster& max_velocity) {
    return pressure_kpa(max_velocity, density_of(scene, flow));
}

Raster pressure_of(const Scene&, const StructuredFlow& flow, const Raster& max_velocity) {
    return flow.max_pressure_where(max_velocity);
}

void add_exchanges_to(const Scene& scene, const Flow& flow, RunResult& result) {
    result.exchanges = scene.entrainment.active();
    if (!result.exchanges) return;
    result.add("eroded_depth", flow.eroded_depth());
    result.add("deposited_depth", flow.deposited_depth());
    result.volume_eroded = flow.exchanged().eroded;
    result.volume_deposited = flow.exchanged().deposited;
    result.momentum_deposited =
        scene.material.density * std::hypot(flow.exchanged().momentum_x, flow.exchanged().momentum_y);
}

void add_exchanges_to(const Scene&, const StructuredFlow&, RunResult&) {}  // its bed is constant

void add_jumps_to(const Scene& scene, const Flow& flow, RunResult& result) {
    const JumpStatistics& jumps = flow.flights().statistics();
    if (!(jumps.volume > 0)) return;
    result.jumps = {jumps.volume,
                    jumps.highest,
                    jumps.longest,
                    jumps.way / jumps.volume,
                    scene.grid.map_from_local(jumps.from),
                    scene.grid.map_from_local(jumps.to)};
    result.add("jump_height", flow.jump_height());
}

void add_jumps_to(const Scene&, const StructuredFlow&, RunResult&) {}  // its material stays on the bed

void add_claims_to(const Scene& scene, const Flow& flow, RunResult& result) {
    const ParticleSet& particles = flow.particles();
    const GridSpec& grid = scene.grid;
    const Raster depth = cell_depth(particles, grid);
    Raster claimed(grid, 0);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Cell c = cell_of(grid, {particles[Field::x][p], particles[Field::y][p]});
        claimed.at(c.row, c.column) += particles[Field::area][p] / grid.cell_area();
    }
    depth.values.for_each_stored([&](std::size_t cell, double deep) {
        if (!(deep > k_claimed_depth)) return;
        const double share = std::as_const(claimed).values[cell];
        const auto place = static_cast<std::int64_t>(cell);
        if (!result.most_claimed || share > result.most_claimed->share)
            result.most_claimed = {share, deep, grid.cell_centre(place / grid.columns, place % grid.columns)};
    });
}

void add_claims_to(const Scene&, const StructuredFlow&, RunResult&) {}  // its solids are particles of fixed size

double volume_of(const Raster& depth) {
    double sum = 0;
    depth.values.for_each_stored([&](std::size_t, double value) { sum += std::isnan(value) ? 0 : value; });
    return sum * depth.grid.cell_area();
}

void make_normal(std::vector<NamedRaster>& rasters, const Raster& bed) {
    for (NamedRaster& raster : rasters)
        if (find_result_raster(raster.name)->is_flow_depth || raster.name == "max_flux")  // depth times speed
            raster.values = normal_depth(raster.values, bed);
}

double pressure_factor(const Flow& flow) {
    return flow.laws().stress.wave_factor;
}

double pressure_factor(const StructuredFlow&) {
    return 1;
}

void prepare_to_record(Flow& flow) {
    flow.record_gathered_velocities();
}

void prepare_to_record(const StructuredFlow&) {}

}  // namespace

void add_arrivals(const Arrivals::Arrived& arrived, Flow& flow) {
    flow.add_particles(arrived.particles);
}

void add_arrivals(const Arrivals::Arrived& arrived, StructuredFlow& flow) {
    flow.add_release(arrived.failed);
    ParticleSet inflow;
    for (std::size_t p = arrived.failed.size(); p < arrived.particles.size(); ++p)
        inflow.push_back(arrived.particles.row(p));
    flow.add_fluid(inflow);
}

Point origin_of(const Release& release, const Arrivals& arrivals) {
    return release.volume > 0 ? release.centroid : arrivals.sources().front().midpoint();
}

template <class AnyFlow>
FlowRun<AnyFlow>::FlowRun(const Scene& scene, const RunOptions& options, Release& release, Arrivals& arrivals,
                          AnyFlow& flow, Stopwatch& engine)
    : scene_(scene),
      options_(options),
      release_(release),
      arrivals_(arrivals),
      flow_(flow),
      engine_(engine),
      next_frame_(scene.time.frame_interval > 0 ? scene.time.frame_interval : std::numeric_limits<double>::infinity()),
      origins_(release, arrivals),
      fade_(scene.time),
      settling_(scene.time, scene.grid, origins_),
      recorder_(scene.recording, scene.grid, scene.numerics),
      watch_(scene, release, arrivals, pressure_factor(flow)) {
    set_origins(flow_, origins_);
    flow_.set_moving_speed(scene.time.moving_speed);
    if (!recorder_.idle()) prepare_to_record(flow_);
    result_.terms = list_terms(scene);
    result_.particles_initial = result_.particles_peak = flow_.particle_count();
    result_.volume_initial = result_.volume_entered = flow_.volume();
    result_.released = release.areas;
    for (ReleasedArea& area : result_.released) area.failed = !(area.start > 0);
    note_scaling(release.areas, result_.notes);
}

template <class AnyFlow>
void FlowRun<AnyFlow>::begin() {
    write_frame_now();
    if (AnyFlow::k_shows_end && !recorder_.idle()) recorder_.record(flow_, 0, 0);
}

template <class AnyFlow>
void FlowRun<AnyFlow>::write_frame_now() {
    if (!options_.on_frame || scene_.time.frame_interval <= 0) return;
    const double interval = scene_.time.frame_interval;
    next_frame_ = interval * (std::floor(flow_.time() / interval * (1 + 1e-12)) + 1);
    last_frame_ = flow_.time();
    engine_.stop();
    Frame arrived = store_frame(flow_, frames_++, options_.particles_in_frames);
    hide_walls(scene_, arrived.depth);
    hide_walls(scene_, arrived.velocity);
    if (result_.hard_events.non_finite > 0) {
        hide_non_finite(arrived.depth);
        hide_non_finite(arrived.velocity);
        for (NamedRaster& raster : arrived.more) hide_non_finite(raster.values);
    }
    if (scene_.recording.normal_depth) {
        arrived.depth = normal_depth(arrived.depth, scene_.terrain);
        make_normal(arrived.more, scene_.terrain);
    }
    options_.on_frame(arrived);
    engine_.start();
}

// Adds the material due now.
template <class AnyFlow>
void FlowRun<AnyFlow>::receive() {
    const Arrivals::Arrived arrived = arrivals_.collect(flow_.time());
    if (scene_.terrain_contains_release && arrived.failed.size() > 0)
        flow_.lower_bed(cell_depth(arrived.failed, scene_.grid));
    add_arrivals(arrived, flow_);
    result_.volume_inflow += arrived.inflow;
    result_.volume_entered += arrived.inflow;
    for (const std::size_t i : arrived.areas) {
        result_.released[i].failed = true;
        result_.volume_entered += result_.released[i].volume;
    }
    settling_.restart(flow_.time());
}

// Actions due when the flow has reached a target time.
template <class AnyFlow>
void FlowRun<AnyFlow>::arrive(double target) {
    flow_.set_time(target);
    if (arrivals_.next_time() <= target) receive();
}

template <class AnyFlow>
void FlowRun<AnyFlow>::count(const StepStatistics& statistics) {
    result_.series.push_back(series_row(flow_, statistics, density_of(scene_, flow_), result_));
    if (statistics.volume > 0) {
        result_.thin_fraction = std::max(result_.thin_fraction, statistics.thin / statistics.volume);
        result_.moving_fraction_limit =
            std::min(1.0, statistics.moving / statistics.volume);  // some may have just left
    }
    result_.particles_peak = std::max(result_.particles_peak, flow_.particle_count());
    result_.hard_events.depth_clamped += statistics.clamped;
    result_.unsupported += statistics.unsupported;
    const BedBudget bed = bed_budget(flow_);
    result_.run_problems = watch_.check(flow_, statistics, result_.volume_entered + bed.eroded - bed.deposited);
    energy_.add(statistics);
    for (const RunProblem& run_problem : result_.run_problems) {
        add(run_problem, result_.hard_events);
        if (options_.on_problem) options_.on_problem(run_problem);
    }
}

template <class AnyFlow>
std::optional<StopReason> FlowRun<AnyFlow>::reason_to_stop(const StepStatistics& statistics) {
    if (!result_.run_problems.empty()) return reason_of(result_.run_problems.front());
    if (arrivals_.done()) {
        if (flow_.empty()) return StopReason::all_left;
        if (scene_.time.stop_when_still && still_.still(statistics)) return StopReason::still;
        if (settling_.settled(flow_, statistics.kinetic, result_.volume_entered + bed_budget(flow_).eroded))
            return StopReason::settled;
        if (fade_.energy(statistics.kinetic)) return StopReason::energy;
        if (fade_.moving(statistics.moving)) return StopReason::moving_volume;
        if (scene_.time.stop_momentum > 0 && fade_.momentum(flow_.momentum())) return StopReason::momentum;
    }
    if (options_.stop_requested && options_.stop_requested()) return StopReason::requested;
    return std::nullopt;
}

template <class AnyFlow>
Progress FlowRun<AnyFlow>::progress() const {
    return {flow_.steps(), flow_.time(), scene_.time.end, flow_.particle_count(), !continues()};
}

template <class AnyFlow>
void FlowRun<AnyFlow>::step() {
    // Only times of the scene's physics, and its end, are met exactly; outputs use the steps as they are.
    const double target = std::min(scene_.time.end, arrivals_.next_time());
    const double left = target - flow_.time();
    // Two equal steps rather than a full one and a very short one.
    const double stable = flow_.stable_step();
    const double limit = left <= stable ? left : left < 2 * stable ? 0.5 * left : left;
    const double began = flow_.time();
    StepStatistics statistics = statistics_of(flow_.advance(limit));
    // A step that does not advance time results from a non-finite value.
    if (!(flow_.time() > began)) statistics.non_finite = std::max<std::int64_t>(statistics.non_finite, 1);
    if (!recorder_.idle()) recorder_.record(flow_, AnyFlow::k_shows_end ? flow_.time() : began, statistics.dt);
    measure_front(flow_, origins_, statistics);
    count(statistics);
    if (target - flow_.time() <= 1e-9 * target) arrive(target);
    if (options_.on_progress) options_.on_progress(progress());
    if (const auto reason = reason_to_stop(statistics)) {
        result_.stop_reason = *reason;
        stopped_ = true;
    }
    if (flow_.nodes().lacks_ground()) {  // the next step cannot be computed; the present state can be saved
        result_.stop_reason = StopReason::requested;
        stopped_ = true;
    }
    // A run that ends here records its last frame in finish(); a paused run must have the frames of an uninterrupted
    // one.
    const bool pauses = stopped_ && result_.stop_reason == StopReason::requested && flow_.time() < scene_.time.end;
    if (flow_.time() >= next_frame_ && (continues() || pauses) && !flow_.nodes().lacks_ground()) write_frame_now();
}

template <class AnyFlow>
RunResult FlowRun<AnyFlow>::finish() {
    RunResult& result = result_;
    const bool finite = result.hard_events.non_finite == 0;
    if (flow_.time() != last_frame_ || result.stop_reason != StopReason::requested) write_frame_now();
    if (finite) flow_.synchronise();
    if (finite) flow_.record_present();
    const Maxima& maxima = flow_.maxima();
    Raster velocity = flow_.to_raster(maxima.speed);
    result.add("max_depth", flow_.to_raster(maxima.depth));
    // A cell that was reached but never moved has speed zero, not "no data".
    result.raster("max_depth").values.for_each_stored([&](std::size_t cell, double depth) {
        double& speed = velocity.values[cell];
        if (!std::isnan(depth) && std::isnan(speed)) speed = 0;
    });
    result.add("arrival_time", flow_.to_raster(maxima.arrival_plus_1, 1));
    result.add("final_depth", flow_.snapshot().depth);
    for (NamedRaster& raster : more_of(flow_)) result.rasters.push_back(std::move(raster));
    hide_walls(scene_, velocity);
    for (NamedRaster& raster : result.rasters) hide_walls(scene_, raster.values);
    if (!finite) hide_non_finite(velocity);
    result.add("max_pressure", pressure_of(scene_, flow_, velocity));
    result.add("max_velocity", std::move(velocity));
    recorder_.move_to(flow_, result);
    add_exchanges_to(scene_, flow_, result);
    add_jumps_to(scene_, flow_, result);
    if (!finite)
        for (NamedRaster& raster : result.rasters) hide_non_finite(raster.values);
    read_ground_under(flow_.nodes(), scene_.terrain, release_.bed);
    result.volume_shown = volume_of(result.raster("final_depth"));
    result.depth_is_normal = scene_.recording.normal_depth;
    if (result.depth_is_normal) make_normal(result.rasters, release_.bed);
    result.add("bed", std::move(release_.bed));
    result.add("release", std::move(release_.depth));
    for (const InflowSource& source : arrivals_.sources())
        for (const Point place : source.places()) result.inflow_places.push_back(scene_.grid.map_from_local(place));
    result.settling = settling_.last();
    result.steps = flow_.steps();
    result.simulated_seconds = flow_.time();
    result.energy_error = energy_.error();
    result.particles_final = flow_.particle_count();
    result.particle_steps = flow_.particle_steps();
    result.bytes_per_particle = static_cast<std::int64_t>(flow_.bytes_per_particle());
    result.bytes_per_node = static_cast<std::int64_t>(flow_.bytes_per_node());
    result.volume_final = flow_.volume();
    result.volume_left = flow_.volume_left();
    if constexpr (requires { flow_.phase_budget(); }) result.phases = flow_.phase_budget();
    if (!arrivals_.done())
        result.notes.emplace_back("the run ended before all release areas had failed or all inflow had entered");
    if (finite) add_claims_to(scene_, flow_, result);
    engine_.stop();
    result.engine_seconds = engine_.seconds();
    return std::move(result);
}

template class FlowRun<Flow>;
template class FlowRun<StructuredFlow>;

}  // namespace frana
