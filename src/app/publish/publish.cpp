// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "app/compare/comparison.h"
#include "app/input/check_inputs.h"
#include "app/input/on_demand.h"
#include "app/input/prepare.h"
#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/publish_pictures.h"
#include "app/publish/publish_project.h"
#include "app/publish/publish_rasters.h"
#include "app/publish/publish_series.h"
#include "app/publish/report.h"
#include "app/publish/report_answer.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/geometry.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "simulation/result.h"
#include "simulation/run_summary.h"
#include "simulation/run_warnings.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

// As much as a map page shows, in multiples of the longer side.
constexpr double k_page_width = 1.6, k_page_height = 1.4;
constexpr std::int64_t k_least_margin = 16;  // [cells]

/// A rectangle of cells, [row0, row1) x [column0, column1).
struct Box {
    std::int64_t row0, row1 = 0, column0, column1 = 0;

    explicit Box(const GridSpec& grid) : row0(grid.rows), column0(grid.columns) {}
    [[nodiscard]] bool empty() const noexcept { return row1 <= row0 || column1 <= column0; }
    void include(std::int64_t row, std::int64_t column) {
        row0 = std::min(row0, row);
        row1 = std::max(row1, row + 1);
        column0 = std::min(column0, column);
        column1 = std::max(column1, column + 1);
    }
    void include(const Raster& raster) {
        raster.values.for_each_stored([&](std::size_t cell, double value) {
            const auto n = static_cast<std::int64_t>(cell);
            if (!std::isnan(value)) include(n / raster.grid.columns, n % raster.grid.columns);
        });
    }
    void include(const GridSpec& grid, const Bounds& area) {
        const auto cell = [&](double metres, std::int64_t count) {
            return static_cast<std::int64_t>(
                std::clamp(std::floor(metres / grid.cell_size), 0.0, static_cast<double>(count - 1)));
        };
        include(cell(grid.north - area.north, grid.rows), cell(area.west - grid.west, grid.columns));
        include(cell(grid.north - area.south, grid.rows), cell(area.east - grid.west, grid.columns));
    }
    void widen(const GridSpec& grid) {
        const auto longer = static_cast<double>(std::max(row1 - row0, column1 - column0));
        const auto widened = [&](std::int64_t& from, std::int64_t& to, double page, std::int64_t count) {
            const auto missing = static_cast<std::int64_t>(page * longer) - (to - from);
            const std::int64_t by = std::max(k_least_margin, (missing + 1) / 2);
            from = std::max<std::int64_t>(0, from - by);
            to = std::min(count, to + by);
        };
        widened(row0, row1, k_page_height, grid.rows);
        widened(column0, column1, k_page_width, grid.columns);
    }
};

bool shows_reached_only(const Prepared& prepared) {
    const std::string& extent = prepared.spec.output.extent;
    return extent == "reached" || (extent == "auto" && prepared.scene.grid.cell_count() > k_largest_whole_map);
}

/// Returns the cells of the map that the rasters of a result cover under output.extent: those round everything that was
/// released, reached or surveyed, with a margin. None: all, and so for a run that is not finished, which --resume
/// continues on the whole map.
std::optional<CellWindow> reached_window(const Prepared& prepared, const RunResult& result) {
    const bool finished = result.stop_reason != StopReason::requested && result.run_problems.empty();
    if (!finished || !shows_reached_only(prepared)) return std::nullopt;
    const GridSpec& grid = result.raster(RasterName::max_depth).grid;
    Box box(grid);
    for (const NamedRaster& raster : result.rasters)
        if (find_result_raster(raster.name)->is_drawn()) box.include(raster.values);
    if (prepared.scar) {
        for (const Feature& feature : prepared.scar->features) box.include(grid, bounds(feature.shape.areas));
    }
    if (box.empty()) return std::nullopt;
    box.widen(grid);
    if (box.row1 - box.row0 == grid.rows && box.column1 - box.column0 == grid.columns) return std::nullopt;
    return CellWindow{box.row0, box.column0, box.row1 - box.row0, box.column1 - box.column0};
}

/// A window of all rasters of a result.
RunResult cut_to(const RunResult& result, const CellWindow& window) {
    RunResult part = result;
    for (NamedRaster& raster : part.rasters) raster.values = frana::cut_to(raster.values, window);
    return part;
}

/// The same for the terrain; the scene's grid remains the one that was computed on.
Prepared cut_to(const Prepared& prepared, const CellWindow& window) {
    Prepared part = prepared;
    part.identity = data_identity(prepared);
    part.scene.terrain = frana::cut_to(prepared.scene.terrain, window);
    if (prepared.friction)
        for (std::optional<Raster>* raster : {&part.scene.zones.friction_coefficient, &part.scene.zones.turbulence})
            *raster = frana::cut_to(**raster, window);
    return part;
}

ComparisonInput comparison_input(const Finished& run) {
    ComparisonInput input = surveyed(run.prepared);
    if (input.survey.empty()) return input;
    input.metadata = result_tags(run.prepared, run.result);
    input.depth = run.result.raster(RasterName::max_depth);
    input.bed = run.result.raster(RasterName::bed);
    input.release = run.result.raster("release");
    input.inflows = run.result.inflow_places;
    input.final_depth = run.result.depth_is_normal ? vertical_depth(run.result.raster(RasterName::final_depth),
                                                                    run.result.raster(RasterName::bed))
                                                   : run.result.raster(RasterName::final_depth);
    input.elevation_change = run.result.raster(RasterName::elevation_change);
    return input;
}

/// Run-out, drop and angle of reach are those of one flow.
void note_flows(const std::vector<Runout>& run_outs, RunLog& log) {
    if (run_outs.size() < 2) return;
    log.note(std::to_string(run_outs.size()) + " separate flows with run-outs from " +
             grouped(run_outs.back().horizontal_m) + " to " + grouped(run_outs.front().horizontal_m) +
             " m; maps and tables show the longest, summary.json lists all");
}

/// Notes what a run did, and what was asked of its values and is claimed of them.
void log_result(const Finished& run, Findings found) {
    const RunResult& result = run.result;
    RunLog& log = found.log;
    for (std::size_t i = 0; i < result.released.size(); ++i)
        if (result.released[i].failed) log.note(released_sentence(result.released[i], i).text());
    if (const auto& file = run.prepared.scene.file_volume)
        log.note("the thickness raster contains " + grouped(file->inside) + " m3 inside the perimeter");
    if (result.volume_inflow > 0) log.note("inflow through lines: " + grouped(result.volume_inflow) + " m3");
    if (result.volume_rained > 0) log.note("rain: " + grouped(result.volume_rained) + " m3");
    if (result.volume_infiltrated > 0) log.note("infiltrated: " + grouped(result.volume_infiltrated) + " m3");
    for (const std::string& note : result.notes) log.note("engine: " + note);
    if (const RunEnd end = run_end(result); end.creeps) log.info(creeping_sentence(end).text());
    log.tell(without(result.warnings, run.prepared.scene.warnings));  // which were told before the run
    if (run.accuracy == nullptr) return;
    const std::vector<ValueEstimate> estimates = value_estimates(*run.accuracy);
    if (!estimates.empty()) log.info("estimated errors:\n" + estimate_lines(estimates));
    const Warning verdict(accuracy_verdict(*run.accuracy), true);
    is_reached(estimates) ? log.info(verdict.words.text()) : found.warn(verdict);
}

/// Writes what the flow does to the exposed features, if there are any.
std::optional<ExposureTotals> publish_exposure(const Prepared& prepared, const RunResult& result,
                                               const ResultDirectory& directory) {
    const auto& layer = prepared.extra.exposure;
    if (!layer) return std::nullopt;
    const Raster& terrain = prepared.scene.terrain;
    const bool is_known =
        !terrain.values.is_tiled() && terrain.grid.same_cells(result.raster(RasterName::max_depth).grid);
    const ReachedPlaces reached(result);
    const auto& fragility = prepared.extra.fragility;
    const bool has_momentum = fragility && fragility->uses(HazardQuantity::momentum);
    const ExposureRasters rasters{
        &reached(RasterName::max_depth),    &reached(RasterName::max_velocity),
        &reached(RasterName::max_pressure), &reached(RasterName::arrival_time),
        is_known ? &terrain : nullptr,      has_momentum ? &reached(RasterName::max_momentum_flux) : nullptr};
    const auto cells = exposed_cells(*layer, result.raster(RasterName::max_depth).grid);
    std::vector<ExposureRow> rows =
        exposure_rows(*layer, exposure_values(cells, rasters), prepared.scene.grid.bounds());
    const bool is_least = is_open(result, prepared.scene);
    std::vector<DamageSum> damages;
    if (fragility) damages.push_back(add_event_damage(*fragility, "", "", is_least, rows));
    ExposureTotals totals =
        write_exposure(*layer, rows, prepared.scene.grid.crs_wkt, words_of(prepared.spec), directory);
    totals.damages = std::move(damages);
    totals.is_least = is_least;
    return totals;
}

/// Writes the comparison with the survey, if there is one. A survey that cannot be compared does not fail the run: it
/// is a warning.
std::optional<Comparison> publish_comparison(const Finished& run, const ResultDirectory& directory, Findings found) {
    const ComparisonInput input = comparison_input(run);
    if (input.survey.empty()) return std::nullopt;
    const auto warn = [&](const Error& error) {
        if (error.kind() != ErrorKind::input) throw error;
        found.warn(worded("the survey could not be compared: {1}", {std::string(error.what())}));
    };
    return attempt(warn, [&] {
        Comparison comparison = compare_with_survey(input);
        Warnings limits = limits_of_use(found.warnings);
        found.warn_all(comparison.warnings);
        comparison.warnings = limits += comparison.warnings;
        write_comparison(comparison, input, directory.path(""));
        const std::string headline = comparison_headline(comparison);
        if (!headline.empty()) found.log.info(headline);
        return std::optional(std::move(comparison));
    });
}

/// The values of the result that more than one file has.
SummaryFacts facts_of(const Finished& run) {
    const Prepared& prepared = run.prepared;
    const double threshold = prepared.spec.output.trace_threshold;
    const TraceFigures trace = trace_figures(run.result, prepared.scene.terrain, threshold);
    SummaryFacts facts;
    facts.spec = prepared.spec;
    facts.computed = prepared.scene.grid;
    facts.crs_label = prepared.ground.crs_label;
    facts.threads = run.threads;
    facts.date = today();
    facts.statistics = {threshold, trace.covered_area_m2, trace.run_outs, run_end(run.result)};
    facts.statistics.end->is_held = gap_contact(run.result, prepared.scene).cells > 0;
    facts.high = trace.high;
    facts.release_ground = prepared.release.ground;
    facts.path_ground = trace.path_ground;
    facts.scheme = hazard_scheme_of(prepared.spec);
    facts.friction = prepared.friction;
    if (facts.friction)
        facts.friction_areas =
            friction_areas(*facts.friction, trace_mask(run.result.raster(RasterName::max_depth), threshold));
    facts.wall.input = run.input_seconds;
    facts.wall.engine = run.result.engine_seconds;
    facts.data_identity = data_identity(prepared);
    (facts.warnings = run.result.warnings) += run.found;
    if (run.accuracy != nullptr) facts.accuracy = *run.accuracy;
    return facts;
}

/// Writes a result on the cells that its rasters have: the pictures before the report, which shows them, and the
/// summary after all that may warn; the project's sheets show what the summary says, and the log is the last.
PictureOutcome publish_all(const Finished& run, const ResultDirectory& directory, const FrameWriter& frames,
                           RunLog& log) {
    const Prepared& prepared = run.prepared;
    const RunResult& result = run.result;
    SummaryFacts facts = facts_of(run);
    const Findings found{log, facts.warnings};
    log_result(run, found);
    const Stopwatch watch;
    const Runout& run_out = facts.statistics.run_out();
    note_flows(facts.statistics.run_outs, log);
    publish_rasters(prepared, result, directory);
    publish_outlines(prepared, result, separate_flows(result), run_out, directory);
    publish_series(prepared, result, directory);
    publish_profiles(prepared, result, run_out, directory);
    facts.hazard = publish_hazard(prepared, result, directory);
    facts.exposure = publish_exposure(prepared, result, directory);
    if (facts.exposure) log.info(exposure_sentence(*facts.exposure, ReachedBy::the_flow));
    write_text_file(directory.path(k_series_file), timeseries_csv(result.series));
    const std::optional<Comparison> comparison = publish_comparison(run, directory, found);
    if (frames.count() > 0) publish_frame_styles(directory.folder());
    facts.wall.output = watch.seconds() + frames.seconds();
    const PictureOutcome pictures = draw_pictures({prepared.spec, directory.path(""), comparison, facts.statistics,
                                                   facts.date, limits_of_use(facts.warnings), &result, run.threads},
                                                  log);
    facts.warnings += pictures.warnings;
    facts.wall.render = watch.seconds() + frames.seconds() - facts.wall.output;
    facts.wall.total = run.earlier_seconds + run.since_start.seconds();
    facts.peak_memory_bytes = peak_memory_bytes();
    ReportInput report{prepared,
                       result,
                       facts,
                       comparison,
                       facts.hazard,
                       error_estimates(facts, directory.target()),
                       words_of(prepared.spec)};
    if (prepared.spec.output.report) write_report(report, directory);
    report.words = Words{};  // a terminal's
    log.info(answer_lines(report));
    write_text_file(directory.path(k_summary_file), summary_json(result, facts));
    log.note("wrote summary.json");
    publish_project(directory.folder(), prepared.spec.output.title.value_or(scene_name(prepared.spec)));
    write_text_file(directory.path(k_log_file), log.text());
    return pictures;
}

}  // namespace

PictureOutcome publish(const Finished& run, const ResultDirectory& directory, FrameWriter& frames, RunLog& log) {
    if (frames.count() > 0) frames.finish();
    const std::optional<CellWindow> window = reached_window(run.prepared, run.result);
    if (!window) {
        if (run.prepared.ground.on_demand) publish_dtm(run.prepared, directory);  // more has been read since the start
        return publish_all(run, directory, frames, log);
    }
    log.note("rasters cover the " + grouped(window->columns) + " x " + grouped(window->rows) +
             " cells round what was reached; output.extent = map gives the whole map");
    const Prepared prepared = cut_to(run.prepared, *window);
    const RunResult result = cut_to(run.result, *window);
    publish_dtm(prepared, directory);
    if (frames.count() > 0) frames.cut_to(*window, run.threads);
    return publish_all({prepared, result, run.threads, run.input_seconds, run.earlier_seconds, run.since_start,
                        run.accuracy, run.found},
                       directory, frames, log);
}

}  // namespace frana::app
