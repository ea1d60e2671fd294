// SPDX-License-Identifier: Apache-2.0
#include <boost/program_options/value_semantic.hpp>
#include <filesystem>
#include <iostream>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/comparison.h"
#include "app/ranking.h"
#include "app/result_reader.h"
#include "app/text_file.h"
#include "app/version.h"
#include "core/error.h"
#include "gis/crs.h"
#include "gis/raster_in.h"
#include "params/scene_spec.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

CommandForm compare_form() {
    namespace options = boost::program_options;
    CommandForm form{
        "frana compare RESULT_DIR|RASTER... --scar VECTOR... [--deposit FILE] [options]",
        "Compares simulated depths with what was surveyed, in any CRS: areas, lines of a front, points of a "
        "tip.\n"
        "Prints the figures and writes comparison.json, comparison_curve.csv, comparison.tif and "
        "comparison.png.\nSeveral results or scars give a folder each, and a ranking in ranking.csv.",
        "RESULT_DIR|RASTER",
        {},
        true};
    form.options.add_options()("scar", options::value<std::vector<std::string>>(),
                               "surveyed areas, open lines (a front) or points (a tip); repeatable")(
        "deposit", options::value<std::string>(),
        "surveyed deposit: polygons, or a raster of elevation after less before")(
        "threshold", options::value<std::string>(),
        "depth in metres over which ground counts as covered (default: the result's, else 0.1)")(
        "out", options::value<std::string>(),
        "folder for the files (default: RESULT_DIR, or the current folder for a RASTER or a ranking)")(
        "size", options::value<std::string>(), "WIDTHxHEIGHT of the map in pixels (default: 1600x1200)");
    return form;
}

/// A raster of another program: depths on square cells in metres.
Raster foreign_depth(const std::string& file) {
    const gis::RasterInfo info = gis::inspect_raster(file, "RESULT_DIR|RASTER");
    if (!info.crs_wkt.empty() && !gis::is_projected_in_metres(info.crs_wkt)) {
        throw Error(ErrorKind::input,
                    Problem{"is not in a projected system in metres, so areas are not known",
                            "RESULT_DIR|RASTER", file, info.crs_label, "Warp it first, with gdalwarp"});
    }
    return gis::read_result_raster(file);
}

/// What is simulated: a result of frana's or one raster of any program's.
struct Simulated {
    ComparisonInput input;
    MapSource source;
    std::string name;          ///< for folders and the ranking
    std::string usual_folder;  ///< where the files go unless told otherwise
};

Simulated read_simulated(const std::string& operand, const std::optional<double>& threshold) {
    Simulated simulated;
    ComparisonInput& input = simulated.input;
    double usual_threshold = OutputSpec{}.trace_threshold;
    simulated.usual_folder = ".";
    if (fs::is_directory(operand)) {
        const ResultReader result(operand);
        input.depth = result.raster("max_depth");
        if (result.has("bed.tif") && result.has("release.tif")) {
            input.bed = result.raster("bed");
            input.release = result.raster("release");
        }
        if (result.has("final_depth.tif")) input.final_depth = result.raster("final_depth");
        simulated.source = result.map_source();
        usual_threshold = result.scene_number("scar.threshold",
                                              result.scene_number("output.trace-threshold", usual_threshold));
        simulated.usual_folder = result.directory();
        input.depth_label = result.path("max_depth.tif");
        simulated.name = fs::absolute(result.directory()).lexically_normal().filename().string();
    } else {
        input.depth = foreign_depth(operand);
        simulated.name = fs::path(operand).stem().string();
        simulated.source.title = simulated.name;
        simulated.source.foreign = true;
        simulated.source.crs_label = gis::crs_name(input.depth.grid.crs_wkt);
        input.depth_label = operand;
    }
    input.metadata = {{"PROGRAM", k_program}, {"VERSION", k_version}};
    input.threshold = threshold.value_or(usual_threshold);
    return simulated;
}

Survey read_survey(const std::optional<std::string>& scar, const std::optional<std::string>& deposit,
                   const GridSpec& grid, RunLog& log) {
    Survey survey;
    if (grid.crs_wkt.empty())
        log.warn("the raster has no CRS: the survey's coordinates are taken as they are");
    if (scar) add_surveyed(*scar, grid.crs_wkt, "--scar", log, survey);
    if (deposit) add_deposit(*deposit, grid, "--deposit", log, survey);
    return survey;
}

std::string make_folder(const std::string& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + failure.message(), "--out", folder,
                                                    "", "Choose another folder"});
    }
    return folder;
}

/// Compares and writes into a folder, which is made only once the figures are there.
Comparison compare_into(Simulated& simulated, const std::string& folder, RunLog& log) {
    Comparison comparison = compare_with_survey(simulated.input, log);
    make_folder(folder);
    write_comparison(comparison, simulated.input, folder);
    if (comparison.figures) {
        simulated.source.scar = simulated.input.survey.scar;
        LayerDrawer drawer(simulated.source);
        draw_comparison(comparison, drawer, (fs::path(folder) / "comparison").string());
    }
    return comparison;
}

}  // namespace

int cmd_compare(const Arguments& arguments) {
    const auto values = parse_arguments(compare_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const std::vector<std::string> scars = text_options(*values, "scar");
    const auto deposit = text_option(*values, "deposit");
    if (scars.empty() && !deposit) {
        throw Error(ErrorKind::input, Problem{"--scar is missing", "command line", "", "",
                                              "Name the surveyed outline: --scar VECTOR"});
    }
    const auto threshold = threshold_option(*values);
    const auto size = size_option(*values);
    const auto out = text_option(*values, "out");
    const auto operands = text_options(*values, "operand");
    const bool several = operands.size() > 1 || scars.size() > 1;
    std::vector<std::optional<std::string>> surveyed(scars.begin(), scars.end());
    if (surveyed.empty()) surveyed.emplace_back();
    RunLog log(false);
    Ranking ranking;
    for (const std::string& operand : operands) {
        Simulated simulated = read_simulated(operand, threshold);
        if (size) simulated.source.style.size = *size;
        for (const auto& scar : surveyed) {
            simulated.input.survey = read_survey(scar, deposit, simulated.input.depth.grid, log);
            if (!several) {
                const Comparison comparison =
                    compare_into(simulated, out.value_or(simulated.usual_folder), log);
                std::cout << comparison_json(comparison, simulated.input);
                return static_cast<int>(ExitCode::done);
            }
            const std::string scar_name = scar ? fs::path(*scar).stem().string() : "deposit";
            const std::string folder = ranking.folder_for(simulated.name, scar_name);
            ranking.add(folder, operand, scar.value_or(deposit.value_or("")),
                        compare_into(simulated, (fs::path(out.value_or(".")) / folder).string(), log));
        }
    }
    write_text_file((fs::path(out.value_or(".")) / "ranking.csv").string(), ranking.csv());
    std::cout << ranking.csv();
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
