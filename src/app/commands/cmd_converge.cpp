// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "analysis/convergence.h"
#include "analysis/trace.h"
#include "app/commands/accuracy_search.h"
#include "app/commands/command_line.h"
#include "app/commands/scene_variants.h"
#include "app/input/share_directory.h"
#include "app/pictures/charts.h"
#include "app/process/terminal.h"
#include "app/publish/publish.h"
#include "app/publish/report_answer.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/json.h"
#include "core/text.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/scene/read_scene.h"
#include "render/canvas/canvas.h"
#include "render/chart/chart.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {

CommandForm converge_form() {
    CommandForm form{"frana converge SCENE.ini [options]",
                     "Runs a scene at several resolutions, the scene's own cell size being the finest and each other "
                     "level twice as\ncoarse, and estimates the error of the finest: convergence.csv, "
                     "convergence.json, convergence.png, uncertainty.tif.",
                     "SCENE.ini",
                     {}};
    form.options.add_options()("out", one("FOLDER"), "folder (default: RESULT_DIR-convergence)")(
        "levels", one("N")->default_value("3"), "number of resolutions, 3 to 6")(
        "set", many("KEY=VALUE"), "section.key=value, overrides the scene; repeatable")(
        "threads", one("N"), "number of threads (default: all processors)")(
        "overwrite", "replace an existing convergence study")("quiet,q", "no progress on the terminal")(
        "json", "print one JSON document for scripts instead (share/doc/scripts.md)");
    return form;
}

namespace {

namespace fs = std::filesystem;

/// Values and cost at one resolution.
struct Level {
    double cell_size = 0;
    std::int64_t particles = 0, steps = 0;
    double wall_seconds = 0;
    RunStatistics statistics;
    Raster depth;
    std::vector<Sentence> warnings;  ///< as `frana run` would give
};

/// A value on the finest cells, and what all levels say of it.
struct EstimatedValue {
    RunStatistic statistic;
    GridConvergence convergence;
};

Level run_level(const Prepared& prepared, const SceneVariants& variants) {
    RunResult result = variants.run(prepared.scene);
    if (!result.run_problems.empty()) {
        throw Error(ErrorKind::numerical,
                    Problem{std::string("the run at ") + number_text(prepared.scene.grid.cell_size) +
                                " m ended early: " + describe(result.stop_reason),
                            "convergence", "", "", "Correct the scene so that `frana run` completes it"});
    }
    Level level;
    level.cell_size = prepared.scene.grid.cell_size;
    level.particles = result.particles_peak;
    level.steps = result.steps;
    level.wall_seconds = result.engine_seconds;
    level.statistics = run_statistics(result, prepared.spec.output.trace_threshold);
    RunLog log(true);
    warn_without_pages(prepared, result, log);
    const Sentence size = numeral(number_text(level.cell_size));
    for (const Sentence& warning : log.warnings())
        level.warnings.push_back(worded("on cells of {1} m: {2}", {size, warning}));
    level.depth = std::move(result.raster("max_depth"));
    return level;
}

std::vector<RunStatistic> reported_statistics() {
    std::vector<RunStatistic> reported;
    std::copy_if(std::begin(k_run_statistics), std::end(k_run_statistics), std::back_inserter(reported), is_reported);
    return reported;
}

/// @param own, half terrain on the finest cells and on half of them; empty: the DTM has no more detail
std::vector<EstimatedValue> estimates_of(const std::vector<Level>& levels, const Raster& own, const Raster& half,
                                         double threshold) {
    const Raster& depth = levels.back().depth;
    const double detail = half.values.empty() ? 0
                                              : unseen_detail(ground_curvature(own, depth, threshold),
                                                              ground_curvature(half, depth, threshold));
    const std::vector<RunStatistic> statistics = reported_statistics();
    std::vector<std::vector<Refinement>> values(statistics.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (const Level& level : levels) values[i].push_back({level.cell_size, statistics[i].of(level.statistics)});
    const std::vector<GridConvergence> convergence = grid_convergence(values, detail);
    std::vector<EstimatedValue> estimates;
    for (std::size_t i = 0; i < values.size(); ++i) estimates.push_back({statistics[i], convergence[i]});
    return estimates;
}

std::string csv_text(const std::vector<Level>& levels) {
    std::string text = "cell_size_m,particles,steps,wall_seconds";
    for (const RunStatistic& name : reported_statistics()) text += std::string(",") + name.key;
    text += '\n';
    for (const Level& l : levels) {
        text += shortest_text(l.cell_size) + ',' + std::to_string(l.particles) + ',' + std::to_string(l.steps) + ',' +
                shortest_text(l.wall_seconds);
        for (const RunStatistic& name : reported_statistics()) text += ',' + shortest_text(name.of(l.statistics));
        text += '\n';
    }
    return text;
}

std::string study_json(const std::vector<Level>& levels, const std::vector<EstimatedValue>& estimates,
                       const SceneSpec& spec) {
    Json json{{"program", k_program},
              {"version", k_version},
              {"scene", spec.file},
              {"finest_cell_size_m", levels.back().cell_size}};
    json["warnings"] = Json::array();
    for (const Level& level : levels)
        for (const std::string& warning : texts_of(level.warnings)) json["warnings"].push_back(warning);
    for (const auto& [name, c] : estimates) {
        json["statistics"][name.key] = {{"finest", name.of(levels.back().statistics)},
                                        {"trend", describe(c.trend)},
                                        {"observed_order", c.observed_order},
                                        {"extrapolated", c.extrapolated},
                                        {"estimated_error", c.error},
                                        {"grid_convergence_index_percent", c.index_percent}};
    }
    return json_text(json);
}

std::string decimals(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

/// The table for the terminal, and the sentences stored for later runs.
std::string table_text(const std::vector<Level>& levels) {
    std::vector<TextTable::Column> columns;
    for (const char* title : {"cell [m]", "particles", "steps", "engine [s]", "depth [m]", "depth 99.9 % [m]",
                              "velocity [m/s]", "velocity 99.9 % [m/s]", "area [m2]", "run-out [m]"})
        columns.push_back({title, 12, true});
    TextTable table(columns, false);
    for (const Level& l : levels)
        table.add({decimals(l.cell_size, 2), std::to_string(l.particles), std::to_string(l.steps),
                   decimals(l.wall_seconds, 1), decimals(l.statistics.depth.greatest, 2),
                   decimals(l.statistics.depth.p999, 2), decimals(l.statistics.speed.greatest, 2),
                   decimals(l.statistics.speed.p999, 2), decimals(l.statistics.covered_area, 0),
                   decimals(l.statistics.run_out, 1)});
    return table.text(output_width());
}

std::string sentences(const std::vector<Level>& levels, const std::vector<EstimatedValue>& estimates) {
    std::string text;
    for (const auto& [name, c] : estimates) {
        text += std::string(name.title) + ' ' + number_text(name.of(levels.back().statistics)) + ' ' + name.unit + ", ";
        if (!std::isfinite(c.error)) {
            text += "not converged\n";
            continue;
        }
        text += "estimated error " + number_text(c.error, 2) + ' ' + name.unit + " (" +
                number_text(c.index_percent, 2) + " %; " + describe(c.trend);
        if (!std::isnan(c.observed_order)) text += ", order " + number_text(c.observed_order, 2);
        text += ")\n";
    }
    return text + "from " + std::to_string(levels.size()) + " resolutions, the finest " +
           number_text(levels.back().cell_size) +
           " m; discretisation only: errors of data and material are not included, and where values oscillate the "
           "estimate is a caution\n";
}

/// Difference of each level's values from their extrapolated values, relative to those, against the cell size.
render::Image chart_of(const std::vector<Level>& levels, const std::vector<EstimatedValue>& estimates,
                       const Words& words) {
    render::Chart chart{words("Convergence"),
                        words("distance from the extrapolated value, if there is one; otherwise from the finest"),
                        "",
                        3,
                        {},
                        true,
                        words};
    for (const auto& [name, convergence] : estimates) {
        const double limit = convergence.extrapolated;
        render::ChartSeries series{words("this scene"), {0, 90, 181}, {}};
        series.marker = render::Marker::circle;
        for (const Level& level : levels) {
            const double distance = std::abs(name.of(level.statistics) - limit) / std::abs(limit);
            if (distance > 0) series.points.push_back({level.cell_size, distance});
        }
        render::ChartPanel panel{words(name.title), words("cell size [m]"), words("relative distance [-]"), {series}};
        panel.x = panel.y = render::Scale::decades;
        panel.note = words("no difference between the levels");
        chart.panels.push_back(std::move(panel));
    }
    return render::draw_chart(chart, 1600, 1100);
}

int level_count(const boost::program_options::variables_map& values) {
    constexpr std::int64_t k_least = 3, k_most = 6;
    const std::string text = values["levels"].as<std::string>();
    const auto count = integer_from_text(text);
    if (!count || *count < k_least || *count > k_most) {
        throw Error(ErrorKind::input, Problem{"is not a number of resolutions", "--levels", text, "3 to 6", ""});
    }
    return static_cast<int>(*count);
}

constexpr const char *k_uncertainty = "uncertainty", *k_chart = "convergence.png", *k_table = "convergence.csv",
                     *k_study = k_convergence_file;

std::vector<std::string> files_of(const fs::path& folder) {
    std::vector<std::string> files;
    files.push_back((folder / k_uncertainty).string() + ".tif");
    for (const char* ending : k_style_endings) files.push_back((folder / k_uncertainty).string() + ending);
    for (const char* file : {k_chart, k_table, k_study, k_error_estimate_file})
        files.push_back((folder / file).string());
    return files;
}

fs::path make_convergence_folder(const std::string& name, bool overwrite, const SceneSpec& spec) {
    fs::path folder = fs::absolute(name);
    KeptFiles kept;
    for (const std::string& file : input_files(spec)) kept.add(file);
    Problems problems;
    kept.check(files_of(folder), "--out", problems);
    problems.throw_if_any();
    if (fs::exists(folder / k_study) && !overwrite) {
        throw Error(ErrorKind::input, Problem{"contains a convergence study already", "--out", folder.string(), "",
                                              "Choose another folder, or add --overwrite"});
    }
    check_own(folder.string(), files_of(folder), "--out", {}, problems);
    problems.throw_if_any();
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + failure.message(), "--out", folder.string(),
                                                    "", "Choose another folder"});
    }
    return folder;
}

/// Puts the errors into the report of the scene's own result, if that is of exactly this scene and has no estimate of
/// its own. Returns the report; empty: there is none, or it stays as it is.
std::string renewed_report(const fs::path& folder, const SceneSpec& spec, double cell_size) {
    const std::string result = output_directory(spec);
    const fs::path scene = fs::path(result) / k_scene_file, summary = fs::path(result) / k_summary_file,
                   report = fs::path(result) / k_report_file;
    if (folder != fs::absolute(convergence_directory(result)) || !fs::exists(report) || !fs::exists(scene)) return {};
    const std::optional<Json> json = read_json_file(summary.string());
    if (!json || json->contains("accuracy")) return {};
    const SceneReading read = read_scene(scene.string(), {}, share_directory());
    if (!read.problems.empty() || numbers_fingerprint(read.scene) != numbers_fingerprint(spec)) return {};
    SummaryFacts facts;
    facts.spec = spec;
    const ErrorEstimates errors = error_estimates(facts, result);
    const auto parts = [&](const Words& words) { return error_parts(errors, cell_size, words); };
    return renew_page(result, parts) ? report.string() : std::string();
}

}  // namespace

int cmd_converge(const Arguments& arguments) {
    const auto values = parse_arguments(converge_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const int count = level_count(*values), threads = thread_count(*values);
    const bool quiet = values->count("quiet") > 0;
    const std::string file = (*values)["operand"].as<std::string>();

    // Every level is read before any is computed: all problems are reported at once, and no study stops half-way.
    SceneVariants variants(file, text_options(*values, "set"), threads, quiet);
    std::vector<Prepared> scenes;
    scenes.push_back(variants.read({}));
    const SceneSpec spec = scenes.front().spec;
    render::vtk();  // for the chart: better missed before the runs than after them
    const fs::path folder =
        make_convergence_folder(text_option(*values, "out").value_or(convergence_directory(output_directory(spec))),
                                values->count("overwrite") > 0, spec);
    const double finest = scenes.front().scene.grid.cell_size;
    for (int k = 1; k < count; ++k) {
        scenes.push_back(variants.read({"terrain.cell-size=" + shortest_text(finest * std::pow(2.0, k))}));
    }

    Raster half;
    if (begin_record(scenes.front()).terrain_cell_size < 0.99 * finest)
        half = variants.read({"terrain.cell-size=" + shortest_text(finest / 2)}).scene.terrain;

    catch_stop_signals();
    std::vector<Level> levels;
    Raster own;
    for (; !scenes.empty(); scenes.pop_back()) {  // the coarsest is the last
        levels.push_back(run_level(scenes.back(), variants));
        if (stop_signal() != 0) return static_cast<int>(ExitCode::signal) + stop_signal();
        own = std::move(scenes.back().scene.terrain);
    }
    const std::vector<EstimatedValue> estimates = estimates_of(levels, own, half, spec.output.trace_threshold);

    RunLog log(quiet);
    for (const Level& level : levels)
        for (const Sentence& warning : level.warnings) log.warn(warning);
    begin_own(folder.string(), files_of(folder));
    std::vector<Raster> depths;
    for (Level& level : levels) depths.push_back(std::move(level.depth));
    const std::string text = sentences(levels, estimates);
    const ResultRaster& row = *find_result_raster(k_uncertainty);
    const Words words = words_of(spec);
    const std::string raster = (folder / k_uncertainty).string() + ".tif";
    const Raster uncertainty = field_uncertainty(depths);
    gis::write_geotiff(raster, uncertainty,
                       {row.name,
                        description_of(row, row.name, spec.output),
                        row.unit,
                        {{"PROGRAM", k_program}, {"VERSION", k_version}}});
    const std::vector<double> classes = class_bounds(row, spec.output.classes, maximum(uncertainty));
    gis::write_styles(raster, gis::class_stops(palette(row.palette), classes, row.unit, words), row.unit,
                      gis::StyleKind::classed, words(row.title));
    write_text_file((folder / k_table).string(), csv_text(levels));
    write_error_estimate(folder.string(), spec, text);
    write_text_file((folder / k_study).string(), study_json(levels, estimates, spec));
    is_drawn(k_chart, log, [&] { render::write_png((folder / k_chart).string(), chart_of(levels, estimates, words)); });
    record_files(files_of(folder));
    const std::string report = renewed_report(folder, spec, finest);
    if (values->count("json") > 0) {
        Json document = document_of("converge");
        document["folder"] = folder.string();
        document["files"] = files_of(folder);
        if (!report.empty()) document["files"].push_back(report);
        document["convergence"] = Json::parse(study_json(levels, estimates, spec));
        document["levels"] = rows_of(csv_text(levels));
        print_document(document);
    } else {
        std::cout << table_text(levels) << '\n' << folded(text, output_width());
    }
    if (!quiet) std::cerr << "frana: convergence study in " << folder.string() << '\n';
    if (!quiet && !report.empty()) std::cerr << "frana: " << report << " shows these errors beside its values\n";
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
