// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "analysis/convergence.h"
#include "analysis/trace.h"
#include "app/commands/accuracy_search.h"
#include "app/commands/command_line.h"
#include "app/commands/scene_variants.h"
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
#include "core/thread_pool.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/scene/read_scene.h"
#include "render/chart/chart.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

/// Values and cost at one resolution.
struct Level {
    double cell_size = 0;
    std::int64_t particles = 0, steps = 0;
    double wall_seconds = 0, cpu_seconds = 0;  ///< of computing
    RunStatistics statistics;
    Raster depth;
    Warnings warnings;  ///< as `frana run` would give
};

/// A value on the finest cells, and what all levels say of it.
struct EstimatedValue {
    RunStatistic statistic;
    GridConvergence convergence;
};

/// The levels of one scheme, the coarsest first.
struct SchemeLevels {
    Scheme scheme = Scheme::standard;
    std::vector<Level> levels{};
    std::vector<EstimatedValue> estimates{};

    [[nodiscard]] std::string name() const { return word_of(scheme, k_schemes); }
    /// How far a value is from its limit at most, relative to that on the finest cells: their distance from a level,
    /// and the estimated error of the finest. Infinite where that does not converge.
    [[nodiscard]] double error(const Level& level, const EstimatedValue& value) const {
        const double finest = value.statistic.of(levels.back().statistics);
        return (std::abs(value.statistic.of(level.statistics) - finest) + value.convergence.error) / std::abs(finest);
    }
    /// Number of values that do not converge.
    [[nodiscard]] std::int64_t unknown() const {
        return std::count_if(estimates.begin(), estimates.end(),
                             [](const EstimatedValue& one) { return !std::isfinite(one.convergence.error); });
    }
    /// The greatest error of a level among the values that converge, and its value; null: none does.
    [[nodiscard]] std::pair<double, const EstimatedValue*> worst(const Level& level) const {
        std::pair<double, const EstimatedValue*> found{k_no_data, nullptr};
        for (const EstimatedValue& one : estimates)
            if (const double own = error(level, one); std::isfinite(own) && !(own <= found.first)) found = {own, &one};
        return found;
    }
};

Level run_level(const Prepared& prepared, const SceneVariants& variants) {
    const double begun = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
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
    level.cpu_seconds = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - begun;
    level.statistics = run_statistics(result, prepared.spec.output.trace_threshold);
    const Sentence size = numeral(number_text(level.cell_size));
    for (const Warning& warning : without(result.warnings, prepared.scene.warnings))
        level.warnings.push_back(worded("{1}: {2}", {worded("cells of {1} m", {size}), warning.words}));
    level.depth = std::move(result.raster(RasterName::max_depth));
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

/// A row for each level.
Json level_rows(const std::vector<SchemeLevels>& schemes) {
    Json rows = Json::array();
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    for (const SchemeLevels& one : schemes)
        for (const Level& l : one.levels) {
            Json& row = rows.emplace_back(Json{{"scheme", one.name()},
                                               {"cell_size_m", number(l.cell_size)},
                                               {"particles", l.particles},
                                               {"steps", l.steps},
                                               {"wall_seconds", number(l.wall_seconds)},
                                               {"cpu_seconds", number(l.cpu_seconds)},
                                               {"error", number(one.worst(l).first)},
                                               {"not_converged", one.unknown()}});
            for (const EstimatedValue& value : one.estimates)
                row[value.statistic.key] = number(value.statistic.of(l.statistics));
            for (const EstimatedValue& value : one.estimates)
                row[std::string("error_") + value.statistic.key] = number(one.error(l, value));
        }
    return rows;
}

/// The same as a table, its titles first.
std::string csv_of(const Json& rows) {
    std::vector<std::string> titles;
    for (const auto& [title, value] : rows.front().items()) titles.push_back(title);
    Table table(titles);
    for (const Json& row : rows) {
        std::vector<Cell> cells;
        for (const Json& value : row)
            cells.push_back(value.is_null()           ? ""
                            : value.is_string()       ? value.get<std::string>()
                            : value.is_number_float() ? shortest_text(value.get<double>())
                                                      : value.dump());
        table.row(cells);
    }
    return table.csv();
}

constexpr double k_good = 0.05;  // error up to which a level counts as good

/// A level of a scheme.
struct Choice {
    const SchemeLevels* scheme;
    const Level* level;
    double error;  ///< the greatest of the values that converge

    [[nodiscard]] bool is_good() const { return scheme->unknown() == 0 && error <= k_good; }
};

/// The level that takes the least time of those whose values are all good; if there is none, of those of the scheme
/// with the most values that converge the one with the least error.
std::optional<Choice> best_level(const std::vector<SchemeLevels>& schemes) {
    const auto key = [](const Choice& one) {
        return std::tuple(!one.is_good(), one.is_good() ? 0 : one.scheme->unknown(),
                          one.is_good() ? one.level->cpu_seconds : one.error);
    };
    std::optional<Choice> best;
    for (const SchemeLevels& one : schemes)
        for (const Level& level : one.levels) {
            const Choice choice{&one, &level, one.worst(level).first};
            if (!std::isnan(choice.error) && (!best || key(choice) < key(*best))) best = choice;
        }
    return best;
}

Json statistics_json(const SchemeLevels& scheme) {
    Json json;
    for (const auto& [name, c] : scheme.estimates)
        json[name.key] = {{"finest", name.of(scheme.levels.back().statistics)},
                          {"trend", describe(c.trend)},
                          {"observed_order", c.observed_order},
                          {"extrapolated", c.extrapolated},
                          {"estimated_error", c.error},
                          {"grid_convergence_index_percent", c.index_percent}};
    return json;
}

std::string study_json(const std::vector<SchemeLevels>& schemes, const SceneSpec& spec) {
    const SchemeLevels& own = schemes.front();
    Json json{{"program", k_program},
              {"version", k_version},
              {"scene", spec.file},
              {"scheme", own.name()},
              {"finest_cell_size_m", own.levels.back().cell_size}};
    json["warnings"] = Json::array();
    for (const SchemeLevels& one : schemes)
        for (const Level& level : one.levels)
            for (const std::string& warning : texts_of(level.warnings)) json["warnings"].push_back(warning);
    json["statistics"] = statistics_json(own);
    for (std::size_t s = 1; s < schemes.size(); ++s)
        json["other_scheme"] = {{"scheme", schemes[s].name()}, {"statistics", statistics_json(schemes[s])}};
    return json_text(json);
}

/// The good level that takes the least time; null: none is good.
Json least_time(const std::vector<SchemeLevels>& schemes) {
    const auto best = best_level(schemes);
    if (!best || !best->is_good()) return {};
    return {{"error", best->error},
            {"scheme", best->scheme->name()},
            {"cell_size_m", best->level->cell_size},
            {"cpu_seconds", best->level->cpu_seconds}};
}

std::string decimals(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string table_text(const std::vector<SchemeLevels>& schemes) {
    Table table({"scheme", "cell [m]", "particles", "steps", "CPU [s]", "error [%]", "not converged", "depth [m]",
                 "depth 99.9 % [m]", "velocity [m/s]", "velocity 99.9 % [m/s]", "area [m2]", "run-out [m]"});
    for (const SchemeLevels& one : schemes)
        for (const Level& l : one.levels)
            table.row({one.name(), decimals(l.cell_size, 2), std::to_string(l.particles), std::to_string(l.steps),
                       decimals(l.cpu_seconds, 2), number_text(100 * one.worst(l).first, 2),
                       std::to_string(one.unknown()), decimals(l.statistics.depth.greatest, 2),
                       decimals(l.statistics.depth.p999, 2), decimals(l.statistics.speed.greatest, 2),
                       decimals(l.statistics.speed.p999, 2), decimals(l.statistics.covered_area, 0),
                       decimals(l.statistics.run_out, 1)});
    std::vector<Table::Layout> columns(table.heads().size(), {12, true});
    columns.front() = {13};
    return table.text(output_width(), columns);
}

/// Which level to take; and how far the schemes are apart on the finest cells, which no error of theirs contains.
std::string advice(const std::vector<SchemeLevels>& schemes) {
    const auto best = best_level(schemes);
    const std::string good = number_text(100 * k_good) + " %";
    if (!best) return "no value converges: no level has an estimated error\n";
    const std::string level = best->scheme->name() + " on cells of " + number_text(best->level->cell_size) + " m, " +
                              number_text(best->level->cpu_seconds, 2) + " s of CPU\n";
    std::string text = "all values within " + good + " in the least time: " + level;
    if (!best->is_good()) {
        const std::int64_t unknown = best->scheme->unknown();
        text = "no level has all values within " + good + "; least error " + number_text(100 * best->error, 2) +
               " % (" + best->scheme->worst(*best->level).second->statistic.title +
               (unknown > 0 ? "; " + std::to_string(unknown) + " do not converge" : "") + "): " + level;
    }
    if (schemes.size() < 2) return text;
    double most = 0;
    std::string title;
    for (const RunStatistic& name : reported_statistics()) {
        const double own = name.of(schemes[0].levels.back().statistics),
                     other = name.of(schemes[1].levels.back().statistics), apart = std::abs(other / own - 1);
        if (apart > most) title = name.title;
        most = std::max(most, apart);
    }
    return text + "on the finest cells the schemes differ by at most " + number_text(100 * most, 2) + " %" +
           (title.empty() ? "" : " (" + title + ")") + "\n";
}

/// The sentences stored for later runs.
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

/// Colours of the scene's scheme and of the other one.
constexpr Rgb k_colours[] = {{0, 90, 181}, {204, 85, 0}};

render::ChartSeries begin_series(const std::vector<SchemeLevels>& schemes, std::size_t scheme) {
    const std::string name = schemes.size() == 1 ? "" : schemes[scheme].name();
    render::ChartSeries series{name, k_colours[scheme], {}};
    series.marker = scheme == 0 ? render::Marker::circle : render::Marker::square;
    return series;
}

/// Greatest error of each level, of the values that converge, against its time.
render::ChartPanel time_panel(const std::vector<SchemeLevels>& schemes, const Words& words) {
    render::ChartPanel panel{words("Accuracy"), words("CPU time") + " [s]", words("Estimated error"), {}};
    for (std::size_t s = 0; s < schemes.size(); ++s) {
        render::ChartSeries series = begin_series(schemes, s);
        for (const Level& level : schemes[s].levels)
            if (const double error = schemes[s].worst(level).first; error > 0)
                series.points.push_back({level.cpu_seconds, error});
        panel.series.push_back(std::move(series));
    }
    panel.x = panel.y = render::Scale::decades;
    panel.note = words("no estimate");
    return panel;
}

/// Difference of each level's values from their extrapolated values, relative to those, against the cell size; and the
/// errors against time.
render::Image chart_of(const std::vector<SchemeLevels>& schemes, const Words& words) {
    render::Chart chart{words("Convergence"), "", "", 4, {}, false, words};
    for (std::size_t i = 0; i < schemes.front().estimates.size(); ++i) {
        const RunStatistic& name = schemes.front().estimates[i].statistic;
        render::ChartPanel panel{words(name.title), words("Cell size") + " [m]", words("Difference"), {}};
        for (std::size_t s = 0; s < schemes.size(); ++s) {
            render::ChartSeries series = begin_series(schemes, s);
            const double limit = schemes[s].estimates[i].convergence.extrapolated;
            for (const Level& level : schemes[s].levels) {
                const double distance = std::abs(name.of(level.statistics) - limit) / std::abs(limit);
                if (distance > 0) series.points.push_back({level.cell_size, distance});
            }
            panel.series.push_back(std::move(series));
        }
        panel.x = panel.y = render::Scale::decades;
        panel.note = words("no estimate");
        chart.panels.push_back(std::move(panel));
    }
    chart.panels.push_back(time_panel(schemes, words));
    return render::draw_chart(chart, 2000, 1100);
}

int level_count(const Options& values) {
    constexpr std::int64_t k_least = 3, k_most = 6;
    const std::string text = values["levels"].as<std::string>();
    const auto count = integer_from_text(text);
    if (!count || *count < k_least || *count > k_most) {
        throw Error(ErrorKind::input, Problem{"is not a number of resolutions", "--levels", text, "3 to 6", ""});
    }
    return static_cast<int>(*count);
}

constexpr const char *k_uncertainty = RasterName::uncertainty, *k_chart = "convergence.png",
                     *k_table = "convergence.csv", *k_study = k_convergence_file;

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
    Problems problems;
    refuse_inputs(files_of(folder), input_files(spec), "--out", problems);
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

/// The scheme with which a scene is compared. Throws Error(input) if it cannot be computed by it.
Scheme other_scheme(const Prepared& prepared, SceneVariants& variants) {
    if (prepared.scene.structured)
        throw Error(ErrorKind::input,
                    Problem{"the structured model has one scheme only", "--schemes", "", "", "Leave it out"});
    const Scheme other =
        prepared.spec.numerics.scheme == Scheme::finite_volume ? Scheme::standard : Scheme::finite_volume;
    static_cast<void>(variants.read({"numerics.scheme=" + word_of(other, k_schemes)}));
    return other;
}

/// Writes the raster of the estimated error of the greatest depth, and its styles. The levels' depths are moved from.
void write_uncertainty(const std::string& raster, std::vector<Level>& levels, const SceneSpec& spec,
                       const Words& words) {
    std::vector<Raster> depths;
    for (Level& level : levels) depths.push_back(std::move(level.depth));
    const ResultRaster& row = *find_result_raster(k_uncertainty);
    const Raster uncertainty = field_uncertainty(depths);
    gis::write_geotiff(raster, uncertainty,
                       {row.name,
                        description_of(row, row.name, spec.output),
                        row.unit,
                        {{"PROGRAM", k_program}, {"VERSION", k_version}}});
    const std::vector<double> classes = class_bounds(row, maximum(uncertainty));
    gis::write_styles(raster, gis::class_stops(palette(row.palette), classes, row.unit, words), row.unit,
                      gis::StyleKind::classed, words(row.title));
}

int cmd_converge(const Options& values) {
    const int count = level_count(values), threads = thread_count(values);
    const bool quiet = values.count("quiet") > 0;
    const std::string file = values["operand"].as<std::string>();

    // Every level is read before any is computed: all problems are reported at once, and no study stops half-way.
    SceneVariants variants(file, text_options(values, "set"), threads, quiet);
    std::vector<Prepared> scenes;
    scenes.push_back(variants.read({}));
    const SceneSpec spec = scenes.front().spec;
    const fs::path folder =
        make_convergence_folder(text_option(values, "out").value_or(convergence_directory(output_directory(spec))),
                                values.count("overwrite") > 0, spec);
    const double finest = scenes.front().scene.grid.cell_size;
    for (int k = 1; k < count; ++k) {
        scenes.push_back(variants.read({"terrain.cell-size=" + shortest_text(finest * std::pow(2.0, k))}));
    }

    Raster half;
    if (begin_record(scenes.front()).terrain_cell_size < 0.99 * finest)
        half = variants.read({"terrain.cell-size=" + shortest_text(finest / 2)}).scene.terrain;

    std::vector<SchemeLevels> schemes{{spec.numerics.scheme}};
    if (values.count("schemes") > 0) schemes.push_back({other_scheme(scenes.front(), variants)});
    catch_stop_signals();
    Raster own;
    for (; !scenes.empty(); scenes.pop_back()) {  // the coarsest is the last
        Prepared& level = scenes.back();
        for (SchemeLevels& one : schemes) {
            level.scene.numerics.scheme = level.spec.numerics.scheme = one.scheme;
            one.levels.push_back(run_level(level, variants));
            if (stop_signal() != 0) return static_cast<int>(ExitCode::signal) + stop_signal();
        }
        own = std::move(level.scene.terrain);
    }
    for (SchemeLevels& one : schemes) one.estimates = estimates_of(one.levels, own, half, spec.output.trace_threshold);
    std::vector<Level>& levels = schemes.front().levels;

    RunLog log(quiet);
    Warnings warnings;
    const Findings found{log, warnings};
    for (const SchemeLevels& one : schemes)
        for (const Level& level : one.levels) found.warn_all(level.warnings);
    begin_own(folder.string(), files_of(folder));
    const Words words = words_of(spec);
    write_uncertainty((folder / k_uncertainty).string() + ".tif", levels, spec, words);
    const std::string text = sentences(levels, schemes.front().estimates);
    const Json rows = level_rows(schemes);
    write_text_file((folder / k_table).string(), csv_of(rows));
    write_error_estimate(folder.string(), spec, text);
    write_text_file((folder / k_study).string(), study_json(schemes, spec));
    is_drawn(k_chart, found, [&] { render::write_png((folder / k_chart).string(), chart_of(schemes, words)); });
    record_files(files_of(folder));
    if (values.count("json") > 0) {
        Json document = document_of("converge");
        document["folder"] = folder.string();
        document["files"] = files_of(folder);
        document["convergence"] = Json::parse(study_json(schemes, spec));
        document["levels"] = rows;
        document["least_time"] = least_time(schemes);
        print_document(document);
    } else {
        std::cout << table_text(schemes) << '\n' << folded(advice(schemes) + text, output_width());
    }
    if (!quiet) std::cerr << "frana: convergence study in " << folder.string() << '\n';
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_converge() {
    CommandForm form{"frana converge SCENE.ini [options]",
                     "Runs a scene at several resolutions, the scene's own cell size being the finest and each other "
                     "level twice as\ncoarse, and estimates error and time of each: convergence.csv, "
                     "convergence.json, convergence.png, uncertainty.tif.",
                     "SCENE.ini",
                     {}};
    form.options.add_options()("out", one("FOLDER"), "folder (default: RESULT_DIR-convergence)")(
        "levels", one("N")->default_value("3"), "number of resolutions, 3 to 6")(
        "schemes", "also by the other scheme, material points or finite volumes: which is accurate in the least time")(
        "set", many("KEY=VALUE"), "section.key=value, overrides the scene; repeatable")(
        "threads", one("N"), "number of threads (default: all processors)")(
        "overwrite", "replace an existing convergence study")("quiet,q", "no progress on the terminal")(
        "json", "print one JSON document for scripts instead (share/doc/scripts.md)");
    return {"converge", "the scene at several resolutions: estimated error", form, cmd_converge};
}

}  // namespace frana::app
