// SPDX-License-Identifier: Apache-2.0
#include "app/commands/forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/commands/command_line.h"
#include "app/input/check_inputs.h"
#include "app/input/memory_bound.h"
#include "app/pictures/animation.h"
#include "app/process/terminal.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

constexpr double k_trial_seconds = 1.5;  // wall, each
// With fewer cells across, the flow of a release differs too much.
constexpr double k_large_cells = 9;
// Smaller cells let thin fronts spread further: growth of the work scaled to the same cells, per halving, in the sample
// and the shared examples.
constexpr double k_usual_growth = 1.3;
// Cost of a trial on half the cells, and half as much for how the runs differ.
constexpr double k_finer_cost = 12;

/// Cost of a run on larger cells, scaled to the scene's own: particles and cells scale with the square of the cells,
/// steps with their side.
struct Trial {
    double work = 0;  ///< as work_of
    double steps = 0;
    double particles_peak = 0;
    double seconds_per_work = 0;
    double reached = 0;  ///< simulated time [s]
    double seconds = 0;  ///< wall time of the engine
    bool cut_short = false;
    std::optional<GroundStatistics> path;
    double left = 0;  ///< fraction of the volume that left the ground
    bool meets_gap = false;
};

/// Particle-steps; of finite volumes, steps of cells with material.
double work_of(const RunResult& result, const GridSpec& grid) {
    if (result.particle_steps > 0) return static_cast<double>(result.particle_steps);
    double area = 0;
    for (const SeriesRow& row : result.series) area += row.covered_area;
    return area / grid.cell_area();
}

Trial try_coarse(const SceneReading& reading, const GridSpec& grid, int factor, int threads) {
    SceneReading coarse = reading;
    coarse.scene.terrain.cell_size = grid.cell_size * factor;
    coarse.scene.terrain.bounds = grid.bounds();
    coarse.scene.observed = {};
    RunLog silent(true);
    const Prepared prepared = prepare(coarse, silent);
    const Stopwatch watch;
    RunOptions options;
    options.threads = threads;
    options.stop_requested = [&] { return watch.seconds() > k_trial_seconds; };
    const RunResult result = run(prepared.scene, options);
    Trial trial;
    trial.reached = result.simulated_seconds;
    trial.cut_short = result.stop_reason == StopReason::requested;
    const double work = work_of(result, prepared.scene.grid), squared = factor * factor;
    const double rest = trial.cut_short ? prepared.scene.time.end / trial.reached : 1;
    trial.work = work * squared * factor * rest;
    trial.steps = static_cast<double>(result.steps) * factor * rest;
    trial.particles_peak = static_cast<double>(result.particles_peak) * squared;
    trial.path = ground_where(prepared.scene.terrain, result.raster(RasterName::max_depth),
                              reading.scene.output.trace_threshold);
    trial.left = left_fraction(result);
    trial.meets_gap = result.stop_reason == StopReason::reached_no_data;
    trial.seconds = result.engine_seconds;
    trial.seconds_per_work = result.engine_seconds / work;
    return trial;
}

}  // namespace

std::optional<TimeEstimate> estimate_time(const SceneReading& reading, const Prepared& prepared,
                                          const RunEstimate& start, int threads) try {
    if (prepared.scene.structured) return std::nullopt;                 // it counts particle steps
    if (prepared.scene.terrain.values.is_tiled()) return std::nullopt;  // larger cells would cover the whole DTM
    const GridSpec& grid = prepared.scene.grid;
    const bool large = prepared.release.area_m2 >= k_large_cells * 64 * grid.cell_area();
    int factor = large ? 4 : 2;
    Trial coarse = try_coarse(reading, grid, 2 * factor, threads);
    Trial fine = try_coarse(reading, grid, factor, threads);
    // Where that took little, once more on half the cells: how long a deposit creeps depends on their size.
    if (factor > 2 && !fine.cut_short && fine.seconds < k_trial_seconds / k_finer_cost) {
        factor /= 2;
        coarse = std::exchange(fine, try_coarse(reading, grid, factor, threads));
    }
    const bool has_particles = prepared.scene.numerics.scheme != Scheme::finite_volume;
    const double units =
        has_particles ? static_cast<double>(start.particles) : released_area(prepared.scene) / grid.cell_area();
    if (!(coarse.work > 0) || (has_particles && start.particles == 0)) return std::nullopt;
    // If both reached their end, the growth per halving of the cells follows from both; otherwise the complete one is
    // used.
    const bool both = !fine.cut_short && !coarse.cut_short;
    const bool use_fine = both || coarse.cut_short;
    const Trial& base = use_fine ? fine : coarse;
    const double growth =
        both ? std::clamp(fine.work / coarse.work, 0.8, has_particles ? 2.0 : k_usual_growth) : k_usual_growth;
    const double more = has_particles ? std::clamp(fine.particles_peak / coarse.particles_peak, 1.0, 2.0) : 1;
    TimeEstimate estimate;
    estimate.coarsening = use_fine ? factor : 2 * factor;
    estimate.trial_end = base.reached;
    estimate.cut_short = base.cut_short;
    estimate.path = fine.path;
    estimate.left = fine.left;
    estimate.meets_gap = fine.meets_gap;
    // With few particles or cells each is expensive (as in the trial), and so are the first steps (of the scene
    // itself).
    const double start_cost = start.wall_seconds * start.first_step_seconds / reading.scene.time.end / units;
    estimate.engine_seconds =
        base.work * std::pow(growth, std::log2(estimate.coarsening)) * std::min(start_cost, fine.seconds_per_work);
    estimate.steps = std::max(fine.steps, coarse.steps);
    estimate.particles_peak = std::max(start.particles, static_cast<std::int64_t>(base.particles_peak * more));
    if (!std::isfinite(estimate.engine_seconds)) return std::nullopt;
    return estimate;
} catch (const Error&) {
    return std::nullopt;  // map too small for larger cells; the scene itself was checked before
}

double engine_seconds(const RunEstimate& start, const std::optional<TimeEstimate>& trial) {
    return trial ? trial->engine_seconds : start.wall_seconds;
}

SchemeTime scheme_time(const SceneReading& reading, int threads) {
    SchemeTime time{word_of(reading.scene.numerics.scheme, k_schemes), "", 0, false};
    const auto refuse = [&](const Error& error) {
        const Problem& problem = error.problems().front();
        time.refusal = problem.where + " " + problem.what;
    };
    attempt(refuse, [&] {
        RunLog silent(true);
        const Prepared prepared = prepare(reading, silent);
        const RunEstimate start = estimate(prepared.scene, threads);
        const std::optional<TimeEstimate> trial = estimate_time(reading, prepared, start, threads);
        time.engine_seconds = engine_seconds(start, trial);
        time.is_lower_bound = !trial;
    });
    return time;
}

namespace {

// All measured, with GDAL 3.6, VTK 9.1 and Mesa 22, on maps of 2000 to 20 000 000 cells and pages of 0.3 to 64 million
// pixels. Results and temporary data while files are written and pictures drawn, after the engine's memory was freed.
constexpr std::int64_t k_result_cell_bytes = 120;
// Code and tables of the drawing libraries, of views with OpenGL's; drawn parts of a map and a view, which remain while
// more are drawn; relief and mesh.
constexpr std::int64_t k_picture_bytes = 38'000'000, k_view_bytes = 60'000'000, k_map_pixel_bytes = 17,
                       k_view_pixel_bytes = 34, k_drawn_cell_bytes = 28;
// The pictures that an encoder keeps in its look-ahead and look-back; a view's animation has two pictures in progress.
constexpr std::int64_t k_animation_bytes = 10'000'000, k_animation_pixel_bytes = 15;
// A step's row in memory, during formatting, and while charts are drawn from the file's text.
constexpr std::int64_t k_step_bytes = 180, k_step_text_bytes = 450, k_step_chart_bytes = 1500;
// Code and tables of computing and writing.
constexpr std::int64_t k_computing_bytes = 20'000'000;
// Frames waiting for the disk contain both quantities, and the last depth stays; particles eight numbers each, VTK's
// and GDAL's copies.
constexpr std::int64_t k_frame_cell_bytes = 48, k_frame_particle_bytes = 330;
// Per cell that nothing reaches: tables of tiles; where the terrain is read whole, its files and the bed's while they
// are written.
constexpr std::int64_t k_table_millibytes = 100, k_ground_cell_bytes = 45;
// Particles split where the flow is thin; a trial without splitting does not predict it.
constexpr double k_unseen_growth = 1.5;

std::int64_t pixels(Size size) {
    return static_cast<std::int64_t>(size.width) * size.height;
}

bool draws_maps(const Prepared& prepared) {
    return prepared.spec.output.maps.front() != "off";
}

// Returns the pictures that publish() draws.
Drawing drawing_of(const Prepared& prepared, std::int64_t cells) {
    const OutputSpec& output = prepared.spec.output;
    const Size page = size_from_text(output.map_size).value_or(Size{});
    Drawing drawing;
    drawing.cells = cells;
    if (draws_maps(prepared) || prepared.scar) drawing.page = page;
    drawing.views = std::any_of(output.maps.begin(), output.maps.end(),
                                [](const std::string& name) { return name.ends_with("_3d"); });
    drawing.maps = prepared.scar || output.charts ||
                   !std::all_of(output.maps.begin(), output.maps.end(),
                                [](const std::string& name) { return name.ends_with("_3d"); });
    if (output.animation && prepared.scene.time.frame_interval > 0) drawing.animation = animation_size(page);
    return drawing;
}

struct Course {
    std::int64_t particles = 0;
    double steps = 0;
};

std::int64_t memory_of(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                       const Course& course) {
    const OutputSpec& output = prepared.spec.output;
    const std::int64_t cells = expected.stored_cells;
    const auto steps = static_cast<std::int64_t>(std::min(course.steps, 1e12));
    std::int64_t engine = expected.memory_bytes + steps * k_step_bytes +
                          expected.bytes_of_particles(std::max<std::int64_t>(0, course.particles - expected.particles));
    if (prepared.scene.time.frame_interval > 0) engine += cells * k_frame_cell_bytes;
    if (prepared.scene.time.frame_interval > 0 && writes_particles(output))
        engine += course.particles * k_frame_particle_bytes;
    const std::int64_t others = prepared.scene.grid.cell_count() - cells;
    const bool tiled = prepared.scene.terrain.values.is_tiled();
    const std::int64_t idle = tiled ? others * k_table_millibytes / 1000 : others * k_ground_cell_bytes;
    if (tiled) engine += idle;
    const std::int64_t results = cells * k_result_cell_bytes + idle;
    const bool charts = output.charts && draws_maps(prepared);
    const std::int64_t writing = results + steps * k_step_text_bytes,
                       drawing = results + memory_of_drawing(drawing_of(prepared, cells)) +
                                 steps * (charts ? k_step_chart_bytes : k_step_bytes);
    return in_use + k_computing_bytes + std::max({engine, writing, drawing});
}

// No speed exceeds that of free fall: a step is at least the time to cross a cell at that speed plus the waves'.
double most_steps(const Prepared& prepared, const RunEstimate& expected) {
    const Scene& scene = prepared.scene;
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    scene.terrain.values.for_each_stored([&](std::size_t, double z) {
        if (std::isnan(z)) return;
        least = std::min(least, z);
        greatest = std::max(greatest, z);
    });
    double speed = std::sqrt(2 * scene.numerics.gravity * std::max(0.0, greatest - least));
    double begun = 0;
    for (const ReleaseArea& area : scene.release) begun = std::max(begun, area.speed);
    speed = std::hypot(speed, begun);
    return scene.time.end / expected.first_step_seconds +
           scene.time.end * speed / (courant_number(scene.numerics, scene.material) * scene.grid.cell_size);
}

}  // namespace

std::int64_t memory_of_drawing(const Drawing& drawing) {
    if (pixels(drawing.page) == 0 && pixels(drawing.animation) == 0) return 0;
    const std::int64_t of_pixel = (drawing.maps ? k_map_pixel_bytes : 0) + (drawing.views ? k_view_pixel_bytes : 0);
    // The animation is drawn after the maps, in the memory they leave: 32 MB more than these alone, measured.
    std::int64_t bytes = k_picture_bytes + (drawing.views ? k_view_bytes : 0) + drawing.cells * k_drawn_cell_bytes +
                         std::max(pixels(drawing.page), pixels(drawing.animation)) * of_pixel;
    if (pixels(drawing.animation) > 0) bytes += k_animation_bytes + pixels(drawing.animation) * k_animation_pixel_bytes;
    return bytes;
}

std::int64_t memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial) {
    Course course;
    course.steps = most_steps(prepared, expected);
    if (trial) {
        course.particles = std::max(trial->particles_peak, expected.particles);
        course.steps = std::min(course.steps, trial->steps);
    } else {
        const double growth = prepared.scene.structured ? 1 : k_unseen_growth;
        course.particles = static_cast<std::int64_t>(growth * static_cast<double>(expected.particles));
    }
    return memory_of(prepared, in_use, expected, course);
}

std::int64_t most_memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected) {
    if (prepared.scene.terrain.values.is_tiled()) return std::numeric_limits<std::int64_t>::max();  // no bound is known
    // Particles that merging leaves in every cell of the map.
    constexpr std::int64_t k_crowd = 3;
    const std::int64_t crowded =
        prepared.scene.structured
            ? 0
            : prepared.scene.grid.cell_count() * std::max(4, prepared.scene.numerics.particles_per_cell) * k_crowd;
    const std::int64_t cells = prepared.scene.grid.cell_count(), nodes = cells * expected.bytes_per_node;
    RunEstimate everywhere = expected;
    everywhere.stored_cells = cells;
    everywhere.memory_bytes += (cells - expected.stored_cells) * k_result_cell_bytes;
    return nodes + memory_of(prepared, in_use, everywhere,
                             {std::max(expected.particles, crowded), most_steps(prepared, expected)});
}

Session session_of(const Options& values, RunLog& log) {
    const auto text = text_option(values, "memory-limit");
    return {text ? memory_limit_from_text(*text, log) : 0};
}

void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared) {
    const MemoryBound bound = usable_memory(reading.session);
    if (static_cast<double>(needed) <= bound.bytes) return;
    throw Error(ErrorKind::input,
                Problem{"a run of this scene needs about " + bytes_text(static_cast<double>(needed)) + " of memory",
                        reading.where("terrain.cell-size"), shortest_text(prepared.scene.grid.cell_size) + " m",
                        bound_text(bound),
                        "Choose a larger terrain.cell-size, a part of the DTM with terrain.bounds, a smaller "
                        "output.map-size or no pictures, or provide more memory"});
}

void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t in_use,
                              const RunEstimate& expected, int threads) {
    if (static_cast<double>(most_memory_of_run(prepared, in_use, expected)) <= usable_memory(reading.session).bytes)
        return;
    refuse_run_of(memory_of_run(prepared, in_use, expected, estimate_time(reading, prepared, expected, threads)),
                  reading, prepared);
}

void refuse_pictures_of(std::int64_t needed, const Place& where, const std::string& size) {
    const MemoryBound bound = machine_memory();
    const double all = static_cast<double>(needed + resident_memory());
    if (all <= bound.bytes) return;
    throw Error(ErrorKind::input, Problem{"drawing needs about " + bytes_text(all) + " of memory", where, size,
                                          bound_text(bound), "Choose a smaller size"});
}

}  // namespace frana::app
