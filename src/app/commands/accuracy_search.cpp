// SPDX-License-Identifier: Apache-2.0
#include "app/commands/accuracy_search.h"

#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "gis/raster/working_grid.h"
#include "params/keys/result_rasters.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

// With fewer cells across, the flow of a release differs too much.
constexpr double k_least_cells = 9;
// Whole numbers of cells, so that the means of the terrain are all made alike. Each has its half and its double, near 4
// h.
constexpr int k_factors[] = {24, 16, 12, 8, 6, 4, 3, 2};
constexpr int k_coarsest_inflow = 8;

AccuracyLevel failed_level(double cell_size, const std::string& problem) {
    AccuracyLevel level;
    level.cell_size = cell_size;
    level.problem = problem;
    return level;
}

}  // namespace

std::vector<double> coarse_cell_sizes(const Prepared& finest) {
    const double own = finest.scene.grid.cell_size, area = finest.release.area_m2;
    std::vector<double> sizes;
    for (const int factor : k_factors) {
        const double size = own * factor;
        const bool fits = area > 0 ? area >= k_least_cells * size * size : factor <= k_coarsest_inflow;
        if (fits) sizes.push_back(size);
    }
    return sizes;
}

Prepared prepare_level(const SceneReading& reading, const Prepared& finest, double cell_size, RunLog& log) {
    SceneReading coarse = reading;
    coarse.warnings.clear();
    coarse.scene.terrain.cell_size = cell_size;
    coarse.scene.terrain.bounds = finest.scene.grid.bounds();
    Prepared level = prepare(coarse, log);
    level.spec = finest.spec;
    level.scene.warnings = finest.scene.warnings;  // of the scene's own cells
    level.identity = data_identity(finest);
    return level;
}

AccuracyRecord begin_record(const Prepared& finest) {
    AccuracyRecord record;
    record.asked = finest.spec.numerics.accuracy.value_or(0);
    record.finest_cell_size = finest.scene.grid.cell_size;
    const GridSpec& grid = finest.scene.grid;
    record.terrain_cell_size =
        gis::working_grid(finest.ground.file, grid.crs_wkt, grid.bounds(), std::nullopt).cell_size;
    return record;
}

AccuracyLevel level_of(const RunResult& result, const Prepared& level, const Raster& finest_terrain) {
    const double threshold = level.spec.output.trace_threshold;
    AccuracyLevel computed;
    computed.cell_size = level.scene.grid.cell_size;
    computed.particles = result.particles_peak;
    computed.steps = result.steps;
    computed.wall_seconds = result.engine_seconds;
    if (!result.run_problems.empty()) {
        computed.problem = std::string("ended early: ") + describe(result.stop_reason);
        return computed;
    }
    computed.curvature = ground_curvature(level.scene.terrain, result.raster(RasterName::max_depth), threshold);
    computed.finest_curvature = ground_curvature(finest_terrain, result.raster(RasterName::max_depth), threshold);
    computed.values = reported_values(result, level.scene, threshold);
    return computed;
}

std::optional<AccuracyLevel> compute_level(const SceneReading& reading, const Prepared& finest, double cell_size,
                                           const RunLevel& run) try {
    RunLog silent(true);
    SceneReading numbers_only = reading;
    numbers_only.scene.observed = {};
    Prepared level = prepare_level(numbers_only, finest, cell_size, silent);
    level.scene.time.frame_interval = 0;
    const RunResult result = run(level.scene);
    if (result.stop_reason == StopReason::requested) return std::nullopt;
    return level_of(result, level, finest.scene.terrain);
} catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    return failed_level(cell_size, "cannot be computed: " + error.problems().front().what);
}

std::optional<AccuracyRecord> choose_cells(const SceneReading& reading, const Prepared& finest, Scheme coarse,
                                           const RunLevel& run, RunLog& log) {
    AccuracyRecord record = begin_record(finest);
    log.info("numerics.accuracy = " + percent_text(record.asked) +
             ": coarser levels first, the finest that may be needed is " + number_text(record.finest_cell_size) + " m");
    record.chosen_cell_size = record.finest_cell_size;
    SceneReading quick = reading;
    quick.scene.numerics.scheme = coarse;
    const bool is_own = coarse == reading.scene.numerics.scheme;
    for (const double size : coarse_cell_sizes(finest)) {
        const auto level = compute_level(quick, finest, size, run);
        if (!level) return std::nullopt;
        record.levels.push_back(*level);
        if (!level->problem.empty()) log.note("cells of " + number_text(size) + " m " + level->problem);
        if (!level->problem.empty() || !is_reached(value_estimates(record))) continue;
        if (!is_own) {
            // The last change contains what lies between the schemes.
            const auto own = compute_level(reading, finest, size, run);
            if (!own) return std::nullopt;
            record.levels.back() = *own;
            if (!own->problem.empty() || !is_reached(value_estimates(record))) {
                record.levels.back() = *level;
                continue;
            }
        }
        record.chosen_cell_size = size;
        break;
    }
    log.info("levels computed:\n" + level_table(record) + "chosen: cells of " + number_text(record.chosen_cell_size) +
             " m");
    return record;
}

}  // namespace frana::app
