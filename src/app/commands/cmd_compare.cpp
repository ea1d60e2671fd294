// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/trace.h"
#include "app/commands/command_line.h"
#include "app/commands/forecast.h"
#include "app/compare/comparison.h"
#include "app/input/check_inputs.h"
#include "app/pictures/charts.h"
#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_numbers.h"
#include "app/pictures/result_reader.h"
#include "app/process/terminal.h"
#include "app/publish/publish_project.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_spec.h"

namespace frana::app {
namespace {

/// One result or raster against one survey, and the folder of the files.
struct Pair {
    std::string operand;
    std::optional<std::string> scar;
    std::string folder;
};

namespace fs = std::filesystem;

bool names_same_file(const std::string& recorded, const std::string& given) {
    std::error_code error;
    return recorded == given || fs::weakly_canonical(recorded, error) == fs::weakly_canonical(given, error);
}

std::vector<std::string> files_of(const Pair& pair, const MapStyle& style) {
    std::vector<std::string> files = comparison_files(pair.folder);
    for (const std::string& picture : comparison_pictures(style, pair.folder)) files.push_back(picture);
    return files;
}

/// Checks, before anything is computed, that no input and no file of a result would be overwritten. Throws
/// Error(input).
void check_outputs(const Pair& pair, const std::optional<std::string>& deposit) {
    MapStyle any;
    any.formats = picture_formats();
    Problems problems;
    const std::vector<std::string> files = files_of(pair, any);
    refuse_inputs(files, {pair.operand, pair.scar.value_or(""), deposit.value_or("")}, "--out", problems);
    check_own(pair.folder, files, "--out", {pair.operand}, problems);
    problems.throw_if_any();
}

/// The same survey may be compared again; what another one gave is not replaced unasked. Throws Error(input).
void refuse_other_survey(const Pair& pair, const std::string& deposit) {
    const std::optional<Json> older = read_json_file((fs::path(pair.folder) / k_comparison_file).string());
    if (!older) return;
    const std::string observed = value_in<std::string>(*older, "/observed").value_or(""),
                      of_deposit = value_in<std::string>(*older, "/deposit/observed").value_or("");
    if (names_same_file(observed, pair.scar.value_or("")) && names_same_file(of_deposit, deposit)) return;
    throw Error(ErrorKind::input, Problem{"contains the comparison with another survey", "--out", pair.folder,
                                          observed.empty() ? of_deposit : observed,
                                          "Choose another folder with --out, or add --overwrite"});
}

/// Throws Error(input) for more than one.
std::string only_one(const std::vector<std::string>& given, const std::string& what) {
    if (given.size() == 1) return given.front();
    throw Error(ErrorKind::input,
                Problem{"is given more than once: one result is compared with one survey", what, joined(given, ", "),
                        "", "Compare each with --out of its own; `frana calibrate` finds the values that agree best"});
}

}  // namespace

namespace {

/// Reads a raster of another program: depths on square cells in metres.
Raster foreign_depth(const std::string& file) {
    refuse_scene(file);
    // GDAL reads more than files: what it names itself (/vsizip/..., NETCDF:...) is left to it.
    if (!fs::exists(file) && file.find(':') == std::string::npos && file.rfind("/vsi", 0) != 0)
        throw Error(ErrorKind::input, Problem{"there is no such result folder or raster", "RESULT_DIR|RASTER", file, "",
                                              "Check the path; it is relative to the current folder"});
    const gis::RasterInfo info = gis::inspect_raster(file, "RESULT_DIR|RASTER");
    if (!info.crs_wkt.empty() && !gis::is_projected_in_metres(info.crs_wkt)) {
        throw Error(ErrorKind::input,
                    Problem{"is not in a projected CRS in metres, so areas cannot be computed", "RESULT_DIR|RASTER",
                            file, info.crs_label, "Warp it first, with gdalwarp"});
    }
    return gis::read_result_raster(file);
}

/// A survey is of one event, and a study's chances are no depths.
void refuse_probability(const std::string& operand) {
    const bool is_study =
        fs::is_directory(operand)
            ? ResultReader(operand).is_of_study()
            : fs::is_regular_file(operand) && attempt([&] { return probability_name(operand).has_value(); });
    if (is_study)
        throw Error(ErrorKind::input,
                    Problem{"is of a study, and one survey is compared with one run", "RESULT_DIR|RASTER", operand, "",
                            "Compare a run with the values of a row of members.csv; `frana calibrate` "
                            "finds the values that agree best"});
}

/// The simulated data: a result of frana or one raster of any program.
struct Simulated {
    ComparisonInput input;
    MapSource source;
};

Simulated read_simulated(const std::string& operand, const std::optional<double>& threshold) {
    Simulated simulated;
    ComparisonInput& input = simulated.input;
    double usual_threshold = OutputSpec{}.trace_threshold;
    if (fs::is_directory(operand)) {
        const ResultReader result(operand);
        input.depth = result.raster(RasterName::max_depth);
        if (result.has("bed.tif") && result.has("release.tif")) {
            input.bed = result.raster(RasterName::bed);
            input.release = result.raster("release");
            input.inflows = flow_tops(read_main_statistics(result.directory()));
        }
        if (result.has("final_depth.tif")) input.final_depth = result.vertical_raster(RasterName::final_depth);
        if (result.has("elevation_change.tif")) input.elevation_change = result.raster(RasterName::elevation_change);
        simulated.source = result.map_source();
        usual_threshold =
            result.scene_number("observed.threshold", result.scene_number("output.trace-threshold", usual_threshold));
        input.depth_label = result.path("max_depth.tif");
        input.words = result.words();
    } else {
        input.depth = foreign_depth(operand);
        simulated.source.title = fs::path(operand).stem().string();
        simulated.source.foreign = true;
        input.words = simulated.source.style.words = Words(process_language());
        simulated.source.crs_label = gis::crs_name(input.depth.grid.crs_wkt);
        input.depth_label = operand;
    }
    input.metadata = {{"PROGRAM", k_program}, {"VERSION", k_version}};
    input.threshold = threshold.value_or(usual_threshold);
    return simulated;
}

/// @param released outlines of the release, empty if unknown
/// @param simulated the survey's CRS and cells are its
Survey read_survey(const std::optional<std::string>& scar, const std::optional<std::string>& deposit,
                   const MultiPolygon& released, const Raster& simulated, Findings found) {
    const GridSpec& grid = simulated.grid;
    Survey survey;
    if (grid.crs_wkt.empty())
        found.warn(worded("the raster has no CRS: the survey's coordinates are used without transformation"));
    if (scar) add_surveyed(*scar, grid.crs_wkt, "--observed", found, survey);
    if (!survey.scar.empty() && !released.empty())
        question_outline(released, survey.scar, padded_to(simulated, bounds(survey.scar), k_no_data).grid, *scar,
                         found);
    if (deposit) add_deposit(*deposit, grid, "--deposit", found, survey);
    return survey;
}

void refuse_too_large(const Simulated& simulated, const Place& where) {
    Drawing drawing;
    drawing.page = simulated.source.style.size;
    drawing.cells = simulated.input.depth.values.stored_cells();
    refuse_pictures_of(memory_of_drawing(drawing), where,
                       std::to_string(drawing.page.width) + "x" + std::to_string(drawing.page.height));
}

std::string make_comparison_folder(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw Error(ErrorKind::environment,
                    Problem{"cannot be made: " + error.message(), "--out", folder, "", "Choose another folder"});
    }
    return folder;
}

/// Compares and writes to a folder, which is made only after the values are computed.
Comparison compare_into(Simulated& simulated, const std::string& folder, Findings found) {
    Comparison comparison = compare_with_survey(simulated.input);
    found.warn_all(comparison.warnings);
    comparison.warnings = found.warnings;
    make_comparison_folder(folder);
    begin_own(folder, comparison.statistics ? comparison_files(folder)
                                            : std::vector<std::string>{comparison_files(folder).front()});
    if (comparison.statistics) begin_own(folder, comparison_pictures(simulated.source.style, folder));
    write_comparison(comparison, simulated.input, folder);
    if (comparison.statistics)
        write_result_shapes((fs::path(folder) / k_comparison_outline).string(), simulated.input.depth.grid.crs_wkt,
                            {{"scar", {{{simulated.input.survey.scar, {}, {}}, {}, {}}}}}, simulated.input.words);
    if (comparison.statistics) {
        simulated.source.scar = simulated.input.survey.scar;
        is_drawn("comparison.png", found, [&] {
            LayerDrawer drawer(simulated.source);
            draw_comparison(comparison, drawer, folder);
        });
    }
    return comparison;
}

/// Adds the comparison to the QGIS project of a result that has one.
void renew_project(const std::string& folder) {
    const std::string project = (fs::path(folder) / k_project_file).string();
    if (!fs::exists(project) || !changed_files({project}).empty()) return;  // QGIS may have saved it
    const ResultReader result(folder);
    begin_own(folder, {project});
    const std::string name = fs::absolute(result.directory()).lexically_normal().filename().string();
    publish_project(folder, result.scene_value("output.title").value_or(name));
    record_files({project});
}

/// Those of the files that exist now.
std::vector<std::string> existing(const std::vector<std::string>& files) {
    std::vector<std::string> there;
    for (const std::string& file : files)
        if (fs::exists(file)) there.push_back(file);
    return there;
}

/// Prints a table and the files that were written.
void print_table(const std::string& table, const std::vector<std::string>& files) {
    std::cout << table << "\nWritten:\n";
    for (const std::string& file : files) std::cout << "  " << one_line(file) << '\n';
}

int cmd_compare(const Options& values) {
    std::vector<std::string> scars = text_options(values, "observed");
    for (const std::string& file : text_options(values, "scar")) scars.push_back(file);
    const auto deposit = text_option(values, "deposit");
    if (scars.empty() && !deposit) {
        throw Error(ErrorKind::input, Problem{"--observed is missing", "command line", "", "",
                                              "Name the surveyed outline: --observed VECTOR"});
    }
    const auto threshold = threshold_option(values);
    const auto size = size_option(values);
    const bool json = values.count("json") > 0;
    const std::string operand = only_one(text_options(values, "operand"), "RESULT_DIR|RASTER");
    const auto scar = scars.empty() ? std::nullopt : std::optional(only_one(scars, "--observed"));
    refuse_probability(operand);
    const std::string usual = fs::is_directory(operand) ? ResultReader(operand).directory() : ".";
    const Pair pair{operand, scar, text_option(values, "out").value_or(usual)};
    check_outputs(pair, deposit);
    if (values.count("overwrite") == 0) refuse_other_survey(pair, deposit.value_or(""));
    RunLog log(false);
    Warnings warnings;
    const Findings found{log, warnings};
    Simulated simulated = read_simulated(operand, threshold);
    if (size) simulated.source.style.size = *size;
    found.warn_all(simulated.source.warnings);  // of the result: its scores are those of what was computed
    refuse_too_large(simulated, size ? "--size" : "output.map-size");
    simulated.input.survey = read_survey(scar, deposit, simulated.source.release, simulated.input.depth, found);
    const Comparison comparison = compare_into(simulated, pair.folder, found);
    record_files(files_of(pair, simulated.source.style));
    renew_project(pair.folder);
    const std::vector<std::string> files = existing(files_of(pair, simulated.source.style));
    if (json) {
        Json document = document_of("compare");
        document["folder"] = pair.folder;
        document["files"] = files;
        document["comparison"] = Json::parse(comparison_json(comparison, simulated.input));
        document["warnings"] = texts_of(warnings);
        print_document(document);
    } else {
        print_table(comparison_table(comparison, simulated.input, output_width()), files);
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_compare() {
    CommandForm form{"frana compare RESULT_DIR|RASTER --observed VECTOR [--deposit FILE] [options]",
                     "Compares simulated depths with a survey, in any CRS: areas, lines of a front, points of a "
                     "tip.\nPrints the scores and writes comparison.json, comparison_curve.csv, comparison.tif and "
                     "comparison.png.",
                     "RESULT_DIR|RASTER",
                     {},
                     true};
    form.options.add_options()("observed", many("FILE"), "surveyed areas, open lines (a front) or points (a tip)")(
        "scar", many("FILE"), "the same as --observed")(
        "deposit", one("FILE"), "surveyed deposit: polygons, or a raster of elevation after minus before")(
        "threshold", one("METRES"),
        "depth in metres over which ground counts as covered (default: the result's, else 0.1)")(
        "out", one("FOLDER"), "folder for the files (default: RESULT_DIR; the current folder for a RASTER)")(
        "overwrite", "replace a comparison with another survey")(
        "size", one("SIZE"), "WIDTHxHEIGHT of the map in pixels (default: 1600x1200)")(
        "json", "print one JSON document for scripts instead (share/doc/scripts.md)");
    return {"compare", "compare a result with a surveyed outline", form, cmd_compare};
}

}  // namespace frana::app
