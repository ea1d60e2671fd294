// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepped_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "core/raster.h"
#include "core/reached_raster.h"
#include "mpm/node_grid.h"
#include "params/keys/result_rasters.h"
#include "simulation/release.h"
#include "simulation/run_summary.h"
#include "simulation/run_warnings.h"
#include "simulation/scene.h"
#include "simulation/terms.h"

namespace frana {
namespace {

constexpr double k_least_window = 10;  // [s]
constexpr double k_samples = 5;        // in a window
constexpr double k_to_come = 3;        // change to come, in those of a window
constexpr double k_calm = 0.1;         // fraction of the kinetic energy's peak below which values may settle
// Bounds of the fraction of the volume that changes cell, in multiples of time.stop-change: less is never asked for on
// fine cells, more never allowed on coarse ones.
constexpr double k_least_of_deposit = 2, k_most_of_deposit = 8;

}  // namespace

SettlingWatch::SettlingWatch(const TimeControl& time, const GridSpec& grid, const FrontOrigins& origins)
    : time_(time), grid_(grid), origins_(origins) {}

void SettlingWatch::restart(double time) {
    since_ = next_ = time;
    peak_ = 0;
    samples_.clear();
}

SettlingWatch::Sample SettlingWatch::sample(const Model& model) const {
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
    model.for_each_active_state([&](std::size_t node, const NodeState& state) {
        if (state.volume_depth > 0) sample.lying.push_back({node, state.volume_depth});
    });
    std::sort(sample.lying.begin(), sample.lying.end(), [](const Lying& a, const Lying& b) { return a.node < b.node; });
    return sample;
}

// Volume that changed cell, over the cell's area. What one cell lost another gained: half the sum of changes; what left
// the map counts half as well.
double SettlingWatch::moved(const std::vector<Lying>& from, const std::vector<Lying>& to) {
    double changed = 0;
    auto a = from.begin(), b = to.begin();
    while (a != from.end() || b != to.end()) {
        if (b == to.end() || (a != from.end() && a->node < b->node)) {
            changed += a++->depth;
        } else if (a == from.end() || b->node < a->node) {
            changed += b++->depth;
        } else {
            changed += std::abs(a++->depth - b++->depth);
        }
    }
    return 0.5 * changed;
}

// The same if all were shifted by a cell, the mean of both directions: the falls between neighbours, which equal the
// rises.
double SettlingWatch::moved_by_a_cell(const std::vector<Lying>& lying, std::uint64_t stride) {
    double falls = 0;
    for (const std::uint64_t step : {std::uint64_t{1}, stride}) {
        auto beside = lying.begin();
        for (const Lying& here : lying) {
            while (beside != lying.end() && beside->node < here.node + step) ++beside;
            const bool there = beside != lying.end() && beside->node == here.node + step;
            falls += std::max(0.0, here.depth - (there ? beside->depth : 0));
        }
    }
    return 0.5 * falls;
}

bool SettlingWatch::settled(const Model& model, double kinetic, double all) {
    peak_ = std::max(peak_, kinetic);
    if (!(time_.stop_change > 0) || model.time() < next_) return false;
    const double length = std::max(k_least_window, time_.stop_window * (model.time() - since_));
    next_ = model.time() + length / k_samples;
    samples_.push_back(sample(model));
    // The window's first sample is the last of those that are old enough.
    const double from = model.time() - length;
    while (samples_.size() > 1 && samples_[1].time <= from) samples_.erase(samples_.begin());
    const Sample &first = samples_.front(), &now = samples_.back();
    if (first.time > from) return false;
    const double each = all > 0 ? grid_.cell_area() / all : 0, most = time_.stop_change;
    Settling change;
    change.window = now.time - first.time;
    change.runout = now.runout - first.runout;
    change.area = now.area > 0 ? (now.area - first.area) / now.area : 0;
    change.deposit = each * moved(first.lying, now.lying);
    change.deposit_error = each * moved_by_a_cell(now.lying, static_cast<std::uint64_t>(model.nodes().stride()));
    change.front_is_final = now.area > 0 && kinetic < k_calm * peak_ && change.area <= most &&
                            k_to_come * change.runout <= std::max(grid_.cell_size, most * now.runout);
    last_ = change;
    return change.front_is_final && change.deposit <= std::clamp(change.deposit_error / k_to_come,
                                                                 k_least_of_deposit * most, k_most_of_deposit * most);
}

// Corrections of the rasters of a run before they are returned.

namespace {

/// A wall's cell contains no material, though the nodes there gather a fraction of particles beside it.
void hide_walls(const Scene& scene, Raster& raster) {
    if (!scene.walls || raster.values.empty()) return;
    scene.walls->values.for_each_stored([&](std::size_t cell, double wall) {
        if (wall == 1 && !std::isnan(std::as_const(raster).values[cell])) raster.values[cell] = k_no_data;
    });
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

SeriesRow series_row(const Model& model, const StepStatistics& statistics, const RunResult& so_far) {
    SeriesRow row;
    row.time = model.time();
    row.step = model.steps();
    row.dt = statistics.dt;
    row.volume = statistics.volume;
    row.volume_left = model.volume_left();
    const BedBudget bed = model.bed_budget();
    row.volume_entered = so_far.volume_entered + bed.rained;
    row.volume_inflow = so_far.volume_inflow;
    row.volume_eroded = bed.eroded;
    row.volume_deposited = bed.deposited;
    row.max_depth = statistics.max_depth;
    row.max_speed = statistics.max_speed;
    row.front_distance = statistics.front_distance;
    row.kinetic_energy = model.density() * statistics.kinetic;
    row.covered_area = static_cast<double>(statistics.covered) * model.nodes().cell_size() * model.nodes().cell_size();
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

// Making a frame does not change the model.
Frame store_frame(Model& model, int index, bool with_particles, bool with_stress) {
    Model::Snapshot shot = model.snapshot();
    // For fluid alone the frame's depth and velocity are complete.
    std::vector<NamedRaster> more = model.particle_count() > 0 ? model.more_rasters() : std::vector<NamedRaster>{};
    PointTable particles = with_particles ? model.particle_table() : PointTable{};
    if (with_stress)
        for (NamedRaster& raster : model.plane_stress(shot.depth, particles)) more.push_back(std::move(raster));
    return {index, model.time(), std::move(shot.depth), std::move(shot.speed), std::move(more), std::move(particles)};
}

double volume_of(const Raster& depth) {
    double sum = 0;
    depth.values.for_each_stored([&](std::size_t, double value) { sum += std::isnan(value) ? 0 : value; });
    return sum * depth.grid.cell_area();
}

/// The depth of the areas that have failed so far.
Raster depth_that_failed(const Release& release, const Arrivals& arrivals) {
    Raster depth = release.depth;
    for (const Entry& entry : arrivals.waiting()) {
        const Raster waiting = cell_depth(entry.particles, depth.grid);
        waiting.values.for_each_stored([&](std::size_t cell, double metres) {
            if (!std::isnan(metres)) depth.values[cell] -= metres;
        });
    }
    return depth;
}

/// What lies at the end minus the release and erosion, plus deposition into the bed; NaN where nothing flowed. Where a
/// fluid is computed beside them the solids lie as densely as they were released, since their fluid drains.
Raster elevation_change(const RunResult& result, const Raster& release) {
    const Raster* const solids = result.phases ? result.find_raster(RasterName::solid_depth) : nullptr;
    const Raster& left = solids != nullptr ? *solids : result.raster(RasterName::final_depth);
    double volume = 0;
    for (const ReleasedArea& area : result.released) volume += area.failed ? area.volume : 0;
    const double bulk =
        solids != nullptr && result.phases->entered.solids > 0 ? volume / result.phases->entered.solids : 1;
    const auto of = [](const Raster* raster, std::size_t cell) {
        const double value = raster != nullptr ? raster->values[cell] : 0;
        return std::isnan(value) ? 0 : value;
    };
    const Raster *const eroded = result.find_raster(RasterName::eroded_depth), *const deposited = result.find_raster(
                                                                                   RasterName::deposited_depth);
    Raster change = reached_raster(release.grid, k_no_data);
    result.raster(RasterName::max_depth).values.for_each_stored([&](std::size_t cell, double depth) {
        if (std::isnan(depth)) return;
        change.values[cell] = bulk * of(&left, cell) - of(&release, cell) - of(eroded, cell) + of(deposited, cell);
    });
    return change;
}

void make_normal(std::vector<NamedRaster>& rasters, const Raster& bed) {
    for (NamedRaster& raster : rasters)
        if (const ResultRaster& row = *find_result_raster(raster.name); row.is_flow_depth || row.of_depth)
            raster.values = normal_depth(raster.values, bed);
}

// What lay in the release before it moved hides how deep the flow became: its maximum elsewhere, where that is less.
void add_outside_depth(const Raster& release, RunResult& result) {
    Raster outside = result.raster(RasterName::max_depth);
    const double deepest = maximum(outside);
    outside.values.change_each_stored([&](std::size_t cell, double& depth) {
        if (release.values[cell] > 0) depth = k_no_data;
    });
    if (maximum(outside) < deepest) result.add(RasterName::outside_depth, std::move(outside));
}

Stopwatch started() {
    Stopwatch watch;
    watch.start();
    return watch;
}

// A run's elevations are relative to its start, independent of later failures: to the ground under the first particle,
// or the middle of the first inflow.
Ground ground_of(const Scene& scene, const Release& release, const Arrivals& arrivals) {
    const ParticleSet& first = release.particles;
    const Point origin = first.size() > 0     ? Point{first[Field::x][0], first[Field::y][0]}
                         : release.volume > 0 ? release.centroid
                                              : arrivals.sources().front().midpoint();
    const Cell cell = cell_of(scene.grid, origin);
    const double z = scene.terrain.at(cell.row, cell.column);
    return std::isnan(z) ? Ground(release.bed_at_start) : Ground(release.bed_at_start, z);
}

}  // namespace

SteppedRun::SteppedRun(const Scene& scene, const RunOptions& options)
    : scene_(scene),
      options_(options),
      engine_(started()),
      release_(make_release(scene)),
      arrivals_(scene, std::exchange(release_.later, {})),
      model_(make_model(scene, ground_of(scene, release_, arrivals_), release_.particles, options.threads)),
      next_frame_(scene.time.frame_interval > 0 ? scene.time.frame_interval : std::numeric_limits<double>::infinity()),
      origins_(release_, arrivals_),
      fade_(scene.time),
      settling_(scene.time, scene.grid, origins_),
      recorder_(scene.recording, scene.grid, scene.numerics),
      watch_(scene, release_, arrivals_, model_->pressure_factor()) {
    release_.particles = ParticleSet();
    model_->set_origins(origins_);
    model_->set_moving_speed(scene.time.moving_speed);
    if (!recorder_.idle()) model_->record_gathered_velocities();
    result_.terms = list_terms(scene);
    result_.particles_initial = result_.particles_peak = model_->particle_count();
    result_.volume_initial = result_.volume_entered = model_->volume();
    result_.released = release_.areas;
    for (ReleasedArea& area : result_.released) area.failed = !(area.start > 0);
    note_scaling(release_.areas, result_.notes);
    model_->nodes().require_ground();  // a read error is found before anything is computed
    if (options.saved != nullptr) {
        (*options.saved)(*this);
        return;
    }
    write_frame_now();
    if (model_->shows_end() && !recorder_.idle()) recorder_.record(*model_, 0, 0);
}

void SteppedRun::write_frame_now() {
    if (!options_.on_frame || scene_.time.frame_interval <= 0) return;
    const double interval = scene_.time.frame_interval;
    // Steps of a cell at first, wider as the root of the distance: a slide of a few cells and a flow of kilometres both
    // have some dozen frames.
    const double cell = scene_.grid.cell_size;
    next_frame_ = follows_motion() ? moved_ + std::max(cell, 0.5 * std::sqrt(cell * moved_))
                                   : interval * (std::floor(model_->time() / interval * (1 + 1e-12)) + 1);
    last_frame_ = model_->time();
    engine_.stop();
    Frame arrived = store_frame(*model_, frames_++, options_.particles_in_frames, scene_.recording.plane_stress);
    hide_walls(scene_, arrived.depth);
    hide_walls(scene_, arrived.velocity);
    if (scene_.recording.plane_stress)
        for (NamedRaster& raster : arrived.more) hide_walls(scene_, raster.values);
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
void SteppedRun::receive() {
    const Arrivals::Arrived arrived = arrivals_.collect(model_->time());
    if (scene_.terrain_contains_release && arrived.failed.size() > 0)
        model_->lower_bed(cell_depth(arrived.failed, scene_.grid));
    model_->add(arrived);
    const double before = result_.volume_entered;
    result_.volume_inflow += arrived.inflow;
    result_.volume_entered += arrived.inflow;
    for (const std::size_t i : arrived.areas) {
        result_.released[i].failed = true;
        result_.volume_entered += result_.released[i].volume;
    }
    // The first drops of a hydrograph are thin, and little of the flow.
    if (before < result_.volume_entered) result_.thin_fraction *= before / result_.volume_entered;
    settling_.restart(model_->time());
}

// Actions due when the flow has reached a target time.
void SteppedRun::arrive(double target) {
    model_->set_time(target);
    if (arrivals_.next_time() <= target) receive();
}

void SteppedRun::count(const StepStatistics& statistics) {
    // The step that ends a run with values that are no numbers has no row: whoever reads the file would refuse it.
    if (const SeriesRow row = series_row(*model_, statistics, result_); std::isfinite(row.volume + row.kinetic_energy))
        result_.series.push_back(row);
    const BedBudget bed = model_->bed_budget();
    const double rain = statistics.volume > 0 ? bed.rained / statistics.volume : 0;  // a film wherever it falls
    result_.thin_fraction = std::max(result_.thin_fraction, statistics.thin_fraction - rain);
    if (statistics.volume > 0)
        result_.moving_fraction_limit =
            std::min(1.0, statistics.moving / statistics.volume);  // some may have just left
    result_.particles_peak = std::max(result_.particles_peak, model_->particle_count());
    result_.hard_events.depth_clamped += statistics.clamped;
    result_.unsupported += statistics.unsupported;
    result_.run_problems =
        watch_.check(*model_, statistics, result_.volume_entered + bed.rained + bed.eroded - bed.deposited);
    energy_.add(statistics);
    for (const RunProblem& run_problem : result_.run_problems) {
        add(run_problem, result_.hard_events);
        if (options_.on_problem) options_.on_problem(run_problem);
    }
}

std::optional<StopReason> SteppedRun::reason_to_stop(const StepStatistics& statistics) {
    if (!result_.run_problems.empty()) return reason_of(result_.run_problems.front());
    // What rains or soaks away changes the flow, though nothing moves.
    const bool rains = scene_.structured && model_->time() < scene_.structured->rain.end(),
               changes = rains || model_->bed_budget().infiltrated > result_.volume_infiltrated;
    if (changes) settling_.restart(model_->time());
    if (arrivals_.done() && !rains && model_->empty()) return StopReason::all_left;
    if (arrivals_.done() && !changes) {
        if (scene_.time.stop_when_still && still_.still(statistics)) return StopReason::still;
        const double all = result_.volume_entered + model_->bed_budget().rained + model_->bed_budget().eroded;
        if (settling_.settled(*model_, statistics.kinetic, all) && result_.moving_fraction_limit <= k_creeping_volume)
            return StopReason::settled;
        if (scene_.time.stop_momentum > 0 && fade_.momentum(model_->momentum())) return StopReason::momentum;
    }
    if (options_.stop_requested && options_.stop_requested()) return StopReason::requested;
    return std::nullopt;
}

Progress SteppedRun::progress() const {
    return {model_->steps(), model_->time(), scene_.time.end, model_->particle_count(), !continues()};
}

void SteppedRun::step() {
    advance();
    if (options_.after_step) options_.after_step(progress(), [&](StateWriter& writer) { writer(*this); });
}

void SteppedRun::advance() {
    // Only times of the scene's physics, and its end, are met exactly; outputs use the steps as they are.
    const double target = std::min(scene_.time.end, arrivals_.next_time());
    const double left = target - model_->time();
    // Two equal steps rather than a full one and a very short one.
    const double stable = model_->stable_step();
    if (options_.before_end && target == scene_.time.end && left < 2 * stable && !std::exchange(nears_end_, true))
        options_.before_end([&](StateWriter& writer) { writer(*this); });
    const double limit = left <= stable ? left : left < 2 * stable ? 0.5 * left : left;
    const double began = model_->time();
    result_.volume_infiltrated = model_->bed_budget().infiltrated;
    StepStatistics statistics = model_->step(limit);
    // A step that does not advance time results from a non-finite value.
    if (!(model_->time() > began)) statistics.non_finite = std::max<std::int64_t>(statistics.non_finite, 1);
    if (!recorder_.idle()) recorder_.record(*model_, model_->shows_end() ? model_->time() : began, statistics.dt);
    count(statistics);
    if (target - model_->time() <= 1e-9 * target) arrive(target);
    if (options_.on_progress) options_.on_progress(progress());
    if (const auto reason = reason_to_stop(statistics)) {
        result_.stop_reason = *reason;
        stopped_ = true;
    }
    if (model_->nodes().lacks_ground()) {  // the next step cannot be computed; the present state can be saved
        result_.stop_reason = StopReason::requested;
        stopped_ = true;
    }
    // A run that ends here records its last frame in finish(); a paused run must have the frames of an uninterrupted
    // one.
    const bool pauses = stopped_ && result_.stop_reason == StopReason::requested && model_->time() < scene_.time.end;
    if (statistics.volume > 0) moved_ += std::sqrt(2 * statistics.kinetic / statistics.volume) * statistics.dt;
    const double reached = follows_motion() ? moved_ : model_->time();
    if (reached >= next_frame_ && (continues() || pauses) && !model_->nodes().lacks_ground()) write_frame_now();
}

RunResult SteppedRun::finish() {
    model_->nodes().require_ground();  // after the last state was saved
    model_->end();
    RunResult& result = result_;
    const bool finite = result.hard_events.non_finite == 0;
    if (model_->time() != last_frame_ || result.stop_reason != StopReason::requested) write_frame_now();
    if (finite) model_->synchronise();
    if (finite) model_->record_present();
    const Maxima& maxima = model_->maxima();
    Raster velocity = model_->to_raster(maxima.speed);
    result.add(RasterName::max_depth, model_->to_raster(maxima.depth));
    // A cell that was reached but never moved has speed zero, not "no data".
    result.raster(RasterName::max_depth).values.for_each_stored([&](std::size_t cell, double depth) {
        double& speed = velocity.values[cell];
        if (!std::isnan(depth) && std::isnan(speed)) speed = 0;
    });
    result.add(RasterName::arrival_time, model_->to_raster(maxima.arrival_plus_1, 1));
    result.add(RasterName::final_depth, model_->snapshot().depth);
    for (NamedRaster& raster : model_->more_rasters()) result.rasters.push_back(std::move(raster));
    if (PointTable none; scene_.recording.plane_stress)
        for (NamedRaster& raster : model_->plane_stress(Raster(result.raster(RasterName::final_depth)), none))
            result.rasters.push_back(std::move(raster));
    hide_walls(scene_, velocity);
    for (NamedRaster& raster : result.rasters) hide_walls(scene_, raster.values);
    if (!finite) hide_non_finite(velocity);
    result.add(RasterName::max_pressure, model_->max_pressure(velocity));
    result.add(RasterName::max_velocity, std::move(velocity));
    recorder_.move_to(*model_, result);
    model_->add_to(result);
    if (!finite)
        for (NamedRaster& raster : result.rasters) hide_non_finite(raster.values);
    read_ground_under(model_->nodes(), scene_.terrain, release_.bed);
    result.volume_shown = volume_of(result.raster(RasterName::final_depth));
    result.add(RasterName::elevation_change,
               elevation_change(result,
                                arrivals_.waiting().empty() ? release_.depth : depth_that_failed(release_, arrivals_)));
    result.depth_is_normal = scene_.recording.normal_depth;
    add_outside_depth(release_.depth, result);
    if (result.depth_is_normal) {
        make_normal(result.rasters, release_.bed);
        make_normal(result.low_flights, release_.bed);
    }
    result.add(RasterName::bed, std::move(release_.bed));
    result.add("release", std::move(release_.depth));
    for (const InflowSource& source : arrivals_.sources())
        for (const Point place : source.places()) result.inflow_places.push_back(scene_.grid.map_from_local(place));
    result.settling = settling_.last();
    result.steps = model_->steps();
    result.simulated_seconds = model_->time();
    // While volume flows in there is hardly a step over which energy could be compared.
    if (!(result.volume_inflow > 0)) result.energy_error = energy_.error();
    result.particles_final = model_->particle_count();
    result.particle_steps = model_->particle_steps();
    result.bytes_per_particle = static_cast<std::int64_t>(model_->bytes_per_particle());
    result.bytes_per_node = static_cast<std::int64_t>(model_->bytes_per_node());
    result.volume_final = model_->volume();
    result.volume_left = model_->volume_left();
    result.volume_rained = model_->bed_budget().rained;
    result.volume_infiltrated = model_->bed_budget().infiltrated;
    result.volume_entered += result.volume_rained;
    if (!arrivals_.done())
        result.notes.emplace_back("the run ended before all release areas had failed or all inflow had entered");
    if (finite && result.volume_rained == 0)
        result.energy_line = energy_line_excess(result, scene_, model_->pressure_factor());
    const Warnings of_model = std::exchange(result.warnings, run_warnings(result, scene_));
    (result.warnings += of_model) += scene_.warnings;
    engine_.stop();
    result.engine_seconds = engine_.seconds();
    return std::move(result);
}

}  // namespace frana
