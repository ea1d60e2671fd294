// SPDX-License-Identifier: Apache-2.0
#include "app/commands/time_estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/process/stopwatch.h"
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
    trial.path = ground_where(prepared.scene.terrain, result.max_depth, reading.scene.output.trace_threshold);
    result.max_depth.values.for_each_stored(
        [&](std::size_t, double depth) { trial.reached_cells += std::isnan(depth) ? 0 : squared; });
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

}  // namespace frana::app
