// SPDX-License-Identifier: Apache-2.0
#include <boost/program_options/value_semantic.hpp>
#include <filesystem>
#include <iostream>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/comparison.h"
#include "app/result_reader.h"
#include "core/error.h"
#include "gis/crs.h"
#include "gis/raster_in.h"
#include "gis/vector_in.h"
#include "params/scene_spec.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

CommandForm compare_form() {
    namespace options = boost::program_options;
    CommandForm form{
        "frana compare RESULT_DIR|RASTER --scar VECTOR [options]",
        "Compares a simulated depth with a surveyed outline in any CRS. Prints the figures and writes "
        "comparison.json,\ncomparison.tif and comparison.png.",
        "RESULT_DIR|RASTER",
        {}};
    form.options.add_options()("scar", options::value<std::string>(), "surveyed outline: any polygon layer")(
        "threshold", options::value<std::string>(),
        "depth in metres over which ground counts as covered (default: the result's, else 0.1)")(
        "out", options::value<std::string>(),
        "folder for the files (default: RESULT_DIR, or the current folder for a RASTER)")(
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

MultiPolygon read_scar(const std::string& file, const std::string& crs_wkt, RunLog& log) {
    const gis::PolygonLayer layer = gis::read_polygons(file, crs_wkt, "--scar");
    for (const std::string& warning : layer.warnings) log.warn("scar: " + warning);
    if (crs_wkt.empty()) log.warn("the raster has no CRS: the scar's coordinates are taken as they are");
    MultiPolygon all;
    for (const PolygonFeature& feature : layer.features)
        all.insert(all.end(), feature.parts.begin(), feature.parts.end());
    return all;
}

std::string output_folder(const std::string& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + failure.message(), "--out", folder,
                                                    "", "Choose another folder"});
    }
    return folder;
}

}  // namespace

int cmd_compare(const Arguments& arguments) {
    const auto values = parse_arguments(compare_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const auto scar = text_option(*values, "scar");
    if (!scar) {
        throw Error(ErrorKind::input, Problem{"--scar is missing", "command line", "", "",
                                              "Name the surveyed outline: --scar VECTOR"});
    }
    const auto threshold = threshold_option(*values);
    const auto size = size_option(*values);
    const std::string operand = (*values)["operand"].as<std::string>();
    RunLog log(false);

    ComparisonInput input;
    MapSource source;
    double usual_threshold = OutputSpec{}.trace_threshold;
    std::string usual_folder = ".";
    if (fs::is_directory(operand)) {
        const ResultReader result(operand);
        input.depth = result.raster("max_depth");
        if (result.has("bed.tif") && result.has("release.tif")) {
            input.bed = result.raster("bed");
            input.release = result.raster("release");
        }
        source = result.map_source();
        usual_threshold = result.scene_number("scar.threshold",
                                              result.scene_number("output.trace-threshold", usual_threshold));
        usual_folder = operand;
        input.depth_label = result.path("max_depth.tif");
    } else {
        input.depth = foreign_depth(operand);
        source.title = fs::path(operand).stem().string();
        source.crs_label = gis::crs_name(input.depth.grid.crs_wkt);
        input.depth_label = operand;
    }
    input.scar_label = *scar;
    input.threshold = threshold.value_or(usual_threshold);
    input.scar = read_scar(*scar, input.depth.grid.crs_wkt, log);
    source.scar = input.scar;
    if (size) source.size = *size;

    const Comparison comparison = compare_with_scar(input, log);
    const std::string folder = output_folder(text_option(*values, "out").value_or(usual_folder));
    write_comparison(comparison, input, folder);
    draw_comparison(comparison, source, (fs::path(folder) / "comparison.png").string());
    std::cout << comparison_json(comparison, input);
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
