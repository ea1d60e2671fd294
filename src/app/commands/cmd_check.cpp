// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "analysis/trace.h"
#include "app/commands/accuracy_search.h"
#include "app/commands/command_line.h"
#include "app/commands/forecast.h"
#include "app/commands/study_check.h"
#include "app/input/check_inputs.h"
#include "app/input/doubt_ground.h"
#include "app/input/memory_bound.h"
#include "app/input/on_demand.h"
#include "app/input/prepare.h"
#include "app/input/prepare_zones.h"
#include "app/input/share_directory.h"
#include "app/input/used_file.h"
#include "app/process/machine_memory.h"
#include "app/process/terminal.h"
#include "app/publish/publish_pictures.h"
#include "app/publish/summary.h"
#include "app/store/recorded_inputs.h"
#include "app/store/result_directory.h"
#include "app/study/plan/read_study.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "core/json.h"
#include "core/text.h"
#include "params/keys/zone_keys.h"
#include "physics/rain.h"
#include "simulation/release.h"
#include "simulation/run_warnings.h"
#include "simulation/scene_values.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// What `frana check SCENE --json` says: share/doc/scripts.md.
struct CheckedScene {
    const Prepared& prepared;
    const RunEstimate& expected;
    const std::optional<TimeEstimate>& trial;
    std::int64_t memory_bytes;
    const std::vector<SchemeTime>& schemes;
    int threads;
    std::string result;  ///< folder
};

Json bounds_json(const Bounds& box) {
    return Json::array({box.west, box.south, box.east, box.north});
}

Json input_json(const UsedFile& file) {
    Json json{{"role", file.role}, {"file", file.path}, {"layer", file.layer.empty() ? Json() : Json(file.layer)}};
    const bool placed = !file.crs_label.empty();  // a table of numbers has no position
    json["crs"] = placed ? Json(file.crs_label) : Json();
    json["bounds"] = placed ? bounds_json(file.bounds) : Json();
    json["content"] = file.content;
    json["nodata"] = file.nodata;
    json["transformation"] = placed ? Json(transform_text(file.transform)) : Json();
    json["accuracy_m"] = placed && file.transform.accuracy_m >= 0 ? Json(file.transform.accuracy_m) : Json();
    return json;
}

Json check_document(const CheckedScene& checked) {
    const Prepared& prepared = checked.prepared;
    const RunEstimate& expected = checked.expected;
    const GridSpec& grid = prepared.scene.grid;
    Json json = document_of("check");
    json["scene"] = prepared.spec.file;
    json["warnings"] = texts_of(prepared.scene.warnings);
    json["inputs"] = Json::array();
    for (const UsedFile& file : prepared.files) json["inputs"].push_back(input_json(file));
    json["grid"] = {{"crs", prepared.ground.crs_label},
                    {"columns", grid.columns},
                    {"rows", grid.rows},
                    {"cell_size_m", grid.cell_size},
                    {"bounds", bounds_json(grid.bounds())},
                    {"nodata_cells", prepared.ground.nodata_cells},
                    {"filled_cells", prepared.ground.filled_cells}};
    json["release"] = {{"volume_m3", expected.volume},
                       {"area_m2", released_area(prepared.scene)},
                       {"inflow_m3", expected.inflow},
                       {"dtm_contains_release", prepared.scene.terrain_contains_release},
                       {"ground", prepared.release.ground ? ground_json(*prepared.release.ground) : Json()}};
    add_defaults(prepared, json);
    if (prepared.friction) json["friction_table"] = friction_json(*prepared.friction, {});
    const auto& trial = checked.trial;
    json["run"] = {{"particles", expected.particles},
                   {"particles_at_most", trial ? Json(trial->particles_peak) : Json()},
                   {"memory_bytes", checked.memory_bytes},
                   {"first_step_s", expected.first_step_seconds},
                   {"end_s", prepared.scene.time.end},
                   {"threads", checked.threads},
                   {"estimated_seconds", engine_seconds(expected, trial)},
                   {"estimate_is_lower_bound", !trial.has_value()},
                   {"path", trial && trial->path ? ground_json(*trial->path) : Json()},
                   {"terms", expected.terms}};
    for (const SchemeTime& one : checked.schemes)
        json["run"]["schemes"].push_back({{"scheme", one.scheme},
                                          {"engine_seconds", one.refusal.empty() ? Json(one.engine_seconds) : Json()},
                                          {"estimate_is_lower_bound", one.is_lower_bound},
                                          {"refused", one.refusal.empty() ? Json() : Json(one.refusal)}});
    json["result"] = result_json(checked.result);
    return json;
}

std::string corners(const Bounds& box, bool degrees) {
    char text[160];
    const int decimals = degrees ? 6 : 2;
    std::snprintf(text, sizeof text, "%.*f %.*f\n%.*f %.*f", decimals, box.west, decimals, box.south, decimals,
                  box.east, decimals, box.north);
    return text;
}

void add(Table& table, const UsedFile& file) {
    const std::string name = file.role + "\n" + std::filesystem::path(file.path).filename().string() +
                             (file.layer.empty() ? "" : "\nlayer " + file.layer);
    const bool placed = !file.crs_label.empty();  // a table of numbers has no position
    table.row(
        {name, file.crs_label, placed ? corners(file.bounds, file.degrees) : "", file.content, file.nodata,
         placed ? transform_text(file.transform) + (file.resampling.empty() ? "" : "\nresampling: " + file.resampling)
                : "",
         placed ? accuracy_text(file.transform) : ""});
}

/// Returns every input as interpreted, and the working grid, as one table. `memory_bytes`: memory of a run on that
/// grid.
std::string input_table(const Prepared& prepared, std::int64_t memory_bytes) {
    Table table({"Input", "CRS", "Extent (west south, east north)", "Resolution, content", "No data",
                 "Operation to the working CRS", "Accuracy"});
    for (const UsedFile& file : prepared.files) add(table, file);
    const TerrainInput& ground = prepared.ground;
    const GridSpec& grid = prepared.scene.grid;
    const std::string filled = ground.filled_cells > 0
                                   ? grouped(ground.filled_cells) + " filled"
                                   : "policy " + word_of(prepared.scene.numerics.nodata, k_nodata_policies);
    table.row({"Working grid", ground.crs_label, corners(grid.bounds(), false),
               grouped(grid.columns) + " x " + grouped(grid.rows) + " of\n" + shortest_text(grid.cell_size) + " m",
               grouped(ground.nodata_cells) + "\n" + filled,
               "memory of a run: about " + bytes_text(static_cast<double>(memory_bytes)), ""});
    return table.text(output_width(), {{24}, {22}, {31}, {22}, {14}, {34}, {8}}, true);
}

}  // namespace

namespace {

/// Rounds to two significant digits, for values of no higher accuracy.
double two_digits(std::int64_t count) {
    const double power = std::pow(10, std::max(0.0, std::floor(std::log10(static_cast<double>(count))) - 1));
    return std::round(static_cast<double>(count) / power) * power;
}

/// Trial runs predict splitting and later speeds within a factor of about two.
std::string time_text(const RunEstimate& expected, const std::optional<TimeEstimate>& trial, double end, int threads) {
    const double engine = engine_seconds(expected, trial);
    const std::string computing = " s of computing on " + std::to_string(threads) + " threads";
    if (!trial)
        return "at least " + number_text(engine, 2) + computing + "; more where the flow spreads" +
               (expected.particles > 0 ? " and particles split" : "");
    return "about " + number_text(engine, 2) + computing + " (" + number_text(engine / 2, 2) + " to " +
           number_text(2 * engine, 2) + " s), from a trial on cells " + std::to_string(trial->coarsening) +
           " times as large" +
           (trial->cut_short ? ", which reached " + number_text(trial->trial_end, 2) + " s"
                             : ", which ended at " + number_text(trial->trial_end, 2) + " s of " + shortest_text(end) +
                                   ": a deposit that creeps on to the end takes about " +
                                   number_text(engine * end / trial->trial_end, 2) + " s");
}

/// Prints obstacles and zones on the working grid.
void print_site(const Scene& scene) {
    bool any = false;
    for (const ZoneRaster& zone : k_zone_rasters) {
        const std::optional<Raster>& raster = scene.zones.*zone.raster;
        if (!raster) continue;
        if (!std::exchange(any, true)) std::printf("\nZones\n");
        // For friction the key of the coefficient: the raster contains tangents.
        const auto key = std::find_if(zone_keys().begin(), zone_keys().end(),
                                      [&](const ZoneKey& k) { return k.what == zone.what && !k.degrees(); });
        std::int64_t cells = 0;
        double least = std::numeric_limits<double>::infinity(), greatest = -least;
        raster->values.for_each_stored([&](std::size_t, double value) {
            if (std::isnan(value)) return;
            ++cells;
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        });
        print_fact(zone.what, number_text(least, 4) + " to " + number_text(greatest, 4) + " " +
                                  (key->unit.empty() ? "(coefficient)" : key->unit) + " on " + grouped(cells) +
                                  " cells" + (raster->values.is_tiled() ? " looked at so far" : ""));
    }
    if (!scene.walls) return;
    std::int64_t walls = 0;
    scene.walls->values.for_each_stored([&](std::size_t, double wall) { walls += wall == 1; });
    std::printf("\nWalls on %s cells\n", grouped(walls).c_str());
}

/// Prints the levels that numerics.accuracy may compute before the scene's own cells; cost as the third power of the
/// number of cells per side.
void print_levels(const Prepared& prepared, const std::optional<TimeEstimate>& trial) {
    if (!prepared.spec.numerics.accuracy) return;
    const double own = prepared.scene.grid.cell_size;
    std::string sizes;
    double cost = 0;
    for (const double size : coarse_cell_sizes(prepared)) {
        sizes += number_text(size) + ", ";
        cost += std::pow(own / size, 3);
    }
    print_fact("accuracy", percent_text(*prepared.spec.numerics.accuracy) +
                               (sizes.empty() ? ": the release is too small for coarser cells; no estimate of error"
                                              : ": cells of " + sizes + "then at most " + number_text(own) + " m"));
    if (trial && !sizes.empty())
        print_fact("", "the coarser ones take about " + number_text(cost * trial->engine_seconds, 2) +
                           " s in all; the estimated time is that of " + number_text(own) + " m");
}

/// The time of the scene's own scheme and of the others that users choose from.
std::vector<SchemeTime> scheme_times(const Prepared& prepared, double own, bool is_lower_bound,
                                     const std::vector<std::string>& set, int threads) {
    if (prepared.scene.structured) return {};  // it has no schemes
    const Scheme scheme = prepared.scene.numerics.scheme;
    std::vector<SchemeTime> times{{word_of(scheme, k_schemes), "", own, is_lower_bound}};
    for (const Scheme other : {Scheme::standard, Scheme::finite_volume})
        if (other != scheme)
            times.push_back(scheme_time(
                read_scene(prepared.spec.file, overridden(set, {"numerics.scheme=" + word_of(other, k_schemes)}),
                           share_directory()),
                threads));
    return times;
}

void print_schemes(const std::vector<SchemeTime>& schemes) {
    for (const SchemeTime& one : schemes)
        print_fact(
            &one == schemes.data() ? "by scheme" : "",
            one.scheme + (one.refusal.empty() ? (one.is_lower_bound ? ": at least " : ": about ") +
                                                    number_text(one.engine_seconds, 2) + " s of computing, an estimate"
                                              : " is not possible: " + one.refusal));
}

void print_run(const Prepared& prepared, const RunEstimate& expected, const std::optional<TimeEstimate>& trial,
               const std::vector<SchemeTime>& schemes, int threads, const std::string& directory) {
    const auto words = [](const std::string& a, const std::string& b) { return a + " " + b; };
    std::printf("\nRun\n");
    print_fact("released",
               words(grouped(expected.volume), "m3 from") + " " + grouped(released_area(prepared.scene)) + " m2");
    if (prepared.friction) print_fact("friction", friction_text(prepared.friction->choice()).text());
    print_defaults(prepared);
    if (expected.inflow > 0) print_fact("flows in", grouped(expected.inflow) + " m3 until the end");
    if (const auto& fluid = prepared.scene.structured; fluid && fluid->rain.falls()) {
        double heaviest = 0;
        for (const RainMap& map : fluid->rain_maps) heaviest = std::fmax(heaviest, maximum(map.intensity));
        print_fact("rain",
                   !fluid->rain_maps.empty()
                       ? "by place, at most " + number_text(heaviest * k_mm_per_hour, 4) + " mm/h"
                       : number_text(1000 * fluid->rain.depth_by(prepared.scene.time.end), 4) + " mm until the end");
    }
    print_fact("DTM", prepared.scene.terrain_contains_release ? "contains the release: the bed lies under it"
                                                              : "is the bed: the release lies on top of it");
    if (prepared.release.ground) print_fact("release", ground_sentence(*prepared.release.ground).text());
    if (trial && trial->path) print_fact("path", ground_sentence(*trial->path).text() + ", of the trial");
    const std::string node_bytes = std::to_string(expected.bytes_per_node) + " bytes per ";
    if (expected.particles == 0) {
        print_fact("fields", node_bytes + "cell");
    } else {
        print_fact(
            "particles",
            grouped(expected.particles) +
                (trial ? " at the start, about " + grouped(two_digits(trial->particles_peak)) + " at most" : ""));
        print_fact("fields",
                   std::to_string(expected.bytes_per_particle) + " bytes per particle, " + node_bytes + "node");
    }
    print_fact("first step", number_text(expected.first_step_seconds, 3) + " s, end at " +
                                 shortest_text(prepared.scene.time.end) + " s at most");
    print_fact("estimated time", time_text(expected, trial, prepared.scene.time.end, threads));
    print_schemes(schemes);
    print_levels(prepared, trial);
    for (std::size_t i = 0; i < expected.terms.size(); ++i) print_fact(i == 0 ? "terms" : "", expected.terms[i]);
    print_result(directory);
}

int cmd_check(const Options& values) {
    const int threads = thread_count(values);
    RunLog log(false);
    const bool json = values.count("json") > 0;
    const Session session = session_of(values, log);
    const std::string file = values["operand"].as<std::string>();
    if (const auto kind = study::study_kind(file)) {
        if (!text_options(values, "set").empty())
            throw Error(ErrorKind::input, Problem{"is for scenes: a study sets its keys itself", "--set", "", "",
                                                  "Set the key in the study's scene"});
        const Json document = check_study(file, *kind, text_option(values, "out"), threads, !json, session, log);
        if (json) print_document(document);
        return static_cast<int>(ExitCode::done);
    }
    const std::vector<std::string> set = text_options(values, "set");
    SceneReading reading = read_scene(file, set, share_directory());
    reading.session = session;
    Warnings warnings;
    const Findings found{log, warnings};
    found.warn_all(changed_inputs(reading));
    // Whether an existing result may be replaced is checked when the scene is run.
    const auto out = text_option(values, "out");
    const std::string directory = out.value_or(output_directory(reading.scene));
    const std::optional<Problem> place_problem = check_result_directory(
        directory, Older::unknown, {}, out ? "--out" : reading.where("output.directory"), reading.problems);
    Prepared prepared = prepare(reading, place_problem, found);
    // The libraries that draw are loaded by a run alone, unless their addresses count: where the shell limits these.
    const bool loads = std::isfinite(address_room());
    load_drawing(prepared.spec, loads ? Loading::now : Loading::later);
    const std::int64_t in_use = resident_memory() + (loads ? 0 : drawing_library_bytes(prepared.spec));
    const RunEstimate expected = estimate(prepared.scene, threads);
    const std::optional<TimeEstimate> trial = estimate_time(reading, prepared, expected, threads);
    const std::int64_t memory = memory_of_run(prepared, in_use, expected, trial);
    refuse_run_of(memory, reading, prepared);
    const std::vector<SchemeTime> schemes =
        scheme_times(prepared, engine_seconds(expected, trial), !trial, set, threads);
    if (!json) {
        std::printf("Scene %s is ready to run.\n", reading.scene.file.c_str());
        std::printf("\n%s", input_table(prepared, memory).c_str());
        print_site(prepared.scene);
        print_run(prepared, expected, trial, schemes, threads, directory);
        std::fflush(stdout);
    }
    found.warn_all(doubt_ground(reading, prepared));
    found.warn_all(doubt_release(prepared.scene));
    if (trial && trial->path) found.warn_all(path_ground_warnings(*trial->path));
    constexpr double k_left = 0.01;  // coarse cells lose a little more at edges
    if (trial && trial->meets_gap)
        found.warn(worded("the trial reached cells without elevation: use a larger DTM or terrain.nodata-policy"));
    if (trial && trial->left > k_left)
        found.warn(worded("{1} % of the volume leaves the DTM: use a larger DTM",
                          {numeral(number_text(100 * trial->left, 2))}));
    found.warn_all(doubt_exposure(prepared));
    prepared.scene.warnings += warnings;
    if (json) print_document(check_document({prepared, expected, trial, memory, schemes, threads, directory}));
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_check() {
    CommandForm form{
        "frana check SCENE.ini|STUDY.ini|REGION.ini [options]",
        "Validates a scene, a study or a region of many runs, and all its files, prints what would run, and writes "
        "nothing.",
        "SCENE.ini",
        {}};
    form.options.add_options()("out", one("FOLDER"), "result directory of the run (overrides output.directory)")(
        "set", many("KEY=VALUE"), "section.key=value, overrides the scene; repeatable")(
        "threads", one("N"), "number of threads (default: all processors)")(
        "memory-limit", one("SIZE"), "refuse a run that would need more (4GB, 500MB)")(
        "json", "print one JSON document for scripts instead (share/doc/scripts.md)");
    return {"check", "validate a scene, a study or a region and print what would run; writes nothing", form, cmd_check};
}

}  // namespace frana::app
