// SPDX-License-Identifier: Apache-2.0
#include "app/commands/time_estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/pictures/animation.h"
#include "app/process/stopwatch.h"
#include "params/grammar/picture_text.h"
#include "params/keys/result_rasters.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

constexpr double k_trial_seconds = 1.5;  // wall, each
// With fewer cells across, the flow of a release differs too much.
constexpr double k_large_cells = 9;
// Smaller cells let thin fronts spread further: growth of particle-steps scaled to the same cells, per halving, in the
// sample and the shared examples.
constexpr double k_usual_growth = 1.3;
// Cost of a trial on half the cells, and half as much for how the runs differ.
constexpr double k_finer_cost = 12;

/// Cost of a run on larger cells, scaled to the scene's own: particles scale with the square of the cells, steps with
/// their side.
struct Trial {
    double particle_steps = 0;
    double steps = 0;
    double particles_peak = 0;
    double reached_cells = 0;
    double seconds_per_particle_step = 0;
    double reached = 0;  ///< simulated time [s]
    double seconds = 0;  ///< wall time of the engine
    bool cut_short = false;
    std::optional<GroundStatistics> path;
};

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
    const double steps = static_cast<double>(result.particle_steps), squared = factor * factor;
    const double rest = trial.cut_short ? prepared.scene.time.end / trial.reached : 1;
    trial.particle_steps = steps * squared * factor * rest;
    trial.steps = static_cast<double>(result.steps) * factor * rest;
    trial.particles_peak = static_cast<double>(result.particles_peak) * squared;
    trial.path = ground_where(prepared.scene.terrain, result.raster("max_depth"), reading.scene.output.trace_threshold);
    result.raster("max_depth").values.for_each_stored([&](std::size_t, double depth) {
        trial.reached_cells += std::isnan(depth) ? 0 : squared;
    });
    trial.seconds = result.engine_seconds;
    trial.seconds_per_particle_step = result.engine_seconds / steps;
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
    if (!(coarse.particles_peak > 0) || start.particles == 0) return std::nullopt;
    // If both reached their end, the growth per halving of the cells follows from both; otherwise the complete one is
    // used.
    const bool both = !fine.cut_short && !coarse.cut_short;
    const bool use_fine = both || coarse.cut_short;
    const Trial& base = use_fine ? fine : coarse;
    const double growth = both ? std::clamp(fine.particle_steps / coarse.particle_steps, 0.8, 2.0) : k_usual_growth;
    const double more = std::clamp(fine.particles_peak / coarse.particles_peak, 1.0, 2.0);
    TimeEstimate estimate;
    estimate.coarsening = use_fine ? factor : 2 * factor;
    estimate.trial_end = base.reached;
    estimate.cut_short = base.cut_short;
    estimate.path = fine.path;
    // With few particles each is expensive (as in the trial), and so are the first steps (of the scene itself).
    const double start_cost =
        start.wall_seconds * start.first_step_seconds / reading.scene.time.end / static_cast<double>(start.particles);
    estimate.engine_seconds = base.particle_steps * std::pow(growth, std::log2(estimate.coarsening)) *
                              std::min(start_cost, fine.seconds_per_particle_step);
    estimate.reached_cells = std::max(fine.reached_cells, coarse.reached_cells);
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

namespace {

// Processor time of the sample with and without each part, beside other work; meant to be right within a factor of two.
// Pictures by their size, per million pixels; the libraries that draw are loaded once.
constexpr double k_loading_s = 0.7, k_picture_s = 0.11, k_film_picture_s = 0.04, k_drawn_bytes = 0.42e6,
                 k_film_picture_bytes = 9e3;
// Rasters, per cell that is stored and not nodata, compressed; the ground fills the whole map.
constexpr double k_cell_s = 60e-9, k_raster_cell_bytes = 3, k_ground_bytes = 2.6;
// Vector layers, tables, charts, the report's text; a row of timeseries.csv.
constexpr double k_rest_s = 0.8, k_rest_bytes = 0.45e6, k_row_bytes = 130;
// Flows spread to about so many times their release.
constexpr double k_usual_spread = 10;
// Pictures of a run besides its maps: comparison and charts; and of a study: charts.
constexpr double k_charts = 3, k_study_charts = 4;
// Rasters that a run writes besides dtm and bed, and a study for each threshold or quantity.
constexpr double k_rasters = 6, k_bands = 2;

double megapixels(const Size& size) {
    return static_cast<double>(size.width) * size.height / 1e6;
}

/// Adds pictures of a scene's maps, each once more in the report as a smaller one.
void add_pictures(const OutputSpec& output, double count, double cells, WritingForecast& forecast) {
    const double size = megapixels(size_from_text(output.map_size).value_or(Size{}));
    forecast.seconds += k_loading_s + count * (size * k_picture_s + cells * k_cell_s);
    forecast.disk_bytes += count * static_cast<double>(output.map_formats.size()) * size * k_drawn_bytes;
    if (output.report) forecast.disk_bytes += std::min(count, k_charts) * size * k_drawn_bytes;
}

/// Number of the maps of output.maps = on that every run of the scene has.
double usual(const SceneSpec& scene) {
    double count = 0;
    for (const std::string& name : usual_maps()) {
        const ResultRaster& row = *find_result_raster(raster_of_map(name));
        const bool is_there = row.is_produced_by == nullptr || row.is_produced_by(scene);
        count += row.command == "run" && is_there && !row.if_it_happens ? 1 : 0;
    }
    return count;
}

double frames_of(const Prepared& prepared, const std::optional<TimeEstimate>& trial) {
    const double interval = prepared.scene.time.frame_interval;
    if (!(interval > 0)) return 0;
    const double end = trial && !trial->cut_short ? trial->trial_end : prepared.scene.time.end;
    return std::ceil(end / interval) + 1;
}

double reached_cells(const Prepared& prepared, const std::optional<TimeEstimate>& trial) {
    return trial ? trial->reached_cells : k_usual_spread * prepared.release.area_m2 / prepared.scene.grid.cell_area();
}

void add_film(const Prepared& prepared, const std::optional<TimeEstimate>& trial, WritingForecast& forecast) {
    const OutputSpec& output = prepared.spec.output;
    const double frames = frames_of(prepared, trial), cells = reached_cells(prepared, trial);
    if (output.frames) {
        forecast.seconds += frames * 2 * cells * k_cell_s;
        forecast.disk_bytes += frames * 2 * 0.5 * cells * k_raster_cell_bytes;
    }
    if (!output.animation) return;
    forecast.seconds += frames * k_film_picture_s;
    forecast.disk_bytes += frames * k_film_picture_bytes;
}

}  // namespace

WritingForecast forecast_writing(const Prepared& prepared, const RunEstimate& expected,
                                 const std::optional<TimeEstimate>& trial) {
    const OutputSpec& output = prepared.spec.output;
    const auto stored = static_cast<double>(expected.stored_cells);
    const double steps = trial ? trial->steps : prepared.scene.time.end / expected.first_step_seconds;
    WritingForecast forecast{k_rest_s + stored * k_rasters * k_cell_s,
                             k_rest_bytes + steps * k_row_bytes + 2 * stored * k_ground_bytes +
                                 k_rasters * reached_cells(prepared, trial) * k_raster_cell_bytes};
    const bool draws = output.maps.front() != "off";
    double maps = 0;
    if (draws) maps = output.maps.front() == "on" ? usual(prepared.spec) : static_cast<double>(output.maps.size());
    const double pictures = maps + (prepared.scar ? 1 : 0) + (draws && output.charts ? k_charts : 0);
    if (pictures > 0) add_pictures(output, pictures, stored, forecast);
    add_film(prepared, trial, forecast);
    return forecast;
}

WritingForecast forecast_study_writing(const study::StudyInput& input, const RunEstimate& member,
                                       const std::optional<TimeEstimate>& trial, int threads) {
    const OutputSpec& output = input.base.spec.output;
    const bool is_region = input.reading.study.per_polygon();
    const auto stored = static_cast<double>(member.stored_cells);
    // A map for each threshold; quantiles, mean and deviation of two quantities, arrivals, counts.
    const double maps = is_region
                            ? 6
                            : static_cast<double>(output.depth_thresholds.size() + output.velocity_thresholds.size() +
                                                  3 * std::size(k_study_quantiles) + 5 + input.table.keys.size());
    WritingForecast forecast{k_rest_s + stored * maps * k_bands * k_cell_s,
                             k_rest_bytes + 2 * stored * k_ground_bytes +
                                 maps * k_bands * reached_cells(input.base, trial) * k_raster_cell_bytes};
    if (output.maps.front() != "off") {
        const double charts = output.charts && !is_region ? k_study_charts : 0;
        add_pictures(output, maps + charts, stored, forecast);
    }
    if (is_region) return forecast;
    forecast.seconds += engine_seconds(member, trial) / threads;
    add_film(input.base, trial, forecast);
    return forecast;
}

WritingForecast forecast_event_writing(const Prepared& event, const RunEstimate& member) {
    const auto stored = static_cast<double>(member.stored_cells);
    WritingForecast forecast{k_rest_s + stored * k_cell_s, k_rest_bytes + stored * k_raster_cell_bytes};
    if (event.spec.output.maps.front() != "off") add_pictures(event.spec.output, 1 + k_study_charts, stored, forecast);
    return forecast;
}

}  // namespace frana::app
