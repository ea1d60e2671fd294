// SPDX-License-Identifier: Apache-2.0
#include <boost/program_options/value_semantic.hpp>
#include <cstdio>
#include <iostream>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/number_text.h"
#include "app/prepare.h"
#include "app/share_directory.h"
#include "app/thickness_volume.h"
#include "core/json.h"
#include "gis/crs.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

CommandForm check_form() {
    namespace options = boost::program_options;
    CommandForm form{"frana check SCENE.ini [options]",
                     "Validates a scene and everything it names, prints what would run, and writes nothing.",
                     "SCENE.ini",
                     {}};
    form.options.add_options()("set", options::value<std::vector<std::string>>(),
                               "section.key=value, overrides the scene; repeatable")(
        "threads", options::value<std::string>(), "number of threads (default: all processors)");
    return form;
}

void line(const std::string& name, const std::string& value) {
    std::printf("  %-16s %s\n", name.c_str(), value.c_str());
}

std::string accuracy_text(const gis::TransformInfo& transform) {
    if (transform.operation.empty() || transform.operation == "none") return "none needed";
    std::string text = transform.operation;
    text += transform.accuracy_m < 0 ? ", accuracy unknown"
                                     : ", accuracy " + figure(transform.accuracy_m, 3) + " m";
    if (transform.needs_missing_grid) text += " (a better one needs a grid file that is not installed)";
    return text;
}

void print_raster(const std::string& title, const gis::RasterInfo& info) {
    const bool degrees = !info.crs_wkt.empty() && !gis::is_projected_in_metres(info.crs_wkt);
    std::printf("\n%s\n", title.c_str());
    line("file", info.path + " (" + info.driver + ", " + info.data_type + ")");
    line("CRS", info.crs_wkt.empty() ? "none" : info.crs_label);
    line("extent", extent_text(info.bounds, degrees));
    line("cells", grouped(info.columns) + " x " + grouped(info.rows) + " of " + figure(info.cell_x, 6) +
                      " x " + figure(info.cell_y, 6));
    line("nodata", info.has_nodata ? figure(info.nodata, 9) : "none declared");
    line("vertical unit", info.vertical_unit.empty() ? "not stated, taken as metres" : info.vertical_unit);
}

void print_vector(const std::string& title, const std::string& file, const gis::PolygonLayer& layer) {
    double area_m2 = 0;
    for (const PolygonFeature& feature : layer.features) area_m2 += area(feature.parts);
    std::printf("\n%s\n", title.c_str());
    line("file", file + ", layer " + layer.layer_name);
    line("CRS", layer.crs_label.empty() ? "none" : layer.crs_label);
    line("transformation", accuracy_text(layer.transform));
    line("extent", extent_text(layer.bounds));
    line("polygons", std::to_string(layer.features.size()) + " features, " + grouped(area_m2) + " m2");
}

void print_inputs(const Prepared& prepared) {
    print_raster("DTM", prepared.ground.file);
    line("transformation", accuracy_text(prepared.ground.transform));
    line("resampling", prepared.ground.resampling_used);
    if (prepared.release.perimeter)
        print_vector("Release perimeter", prepared.spec.release.perimeter.value(),
                     *prepared.release.perimeter);
    for (const gis::RasterInfo& file : prepared.release.thickness_files)
        print_raster("Release thickness", file);
    if (prepared.scar) print_vector("Scar", prepared.spec.scar.perimeter.value(), *prepared.scar);
}

void print_run(const Prepared& prepared, const RunEstimate& expected, int threads) {
    const GridSpec& grid = prepared.scene.grid;
    const auto words = [](const std::string& a, const std::string& b) { return a + " " + b; };
    std::printf("\nWorking grid\n");
    line("CRS", prepared.ground.crs_label);
    line("extent", extent_text(grid.bounds()));
    line("cells",
         grouped(grid.columns) + " x " + grouped(grid.rows) + " of " + shortest_text(grid.cell_size) + " m");
    line("without data",
         grouped(prepared.ground.nodata_cells) + " cells, " +
             (prepared.ground.filled_cells > 0 ? grouped(prepared.ground.filled_cells) + " filled"
                                               : "policy " + prepared.spec.terrain.nodata_policy));
    std::printf("\nRun\n");
    line("released",
         words(grouped(expected.volume), "m3 from") + " " + grouped(prepared.release.area_m2) + " m2");
    line("DTM", prepared.scene.terrain_contains_release ? "contains the release: the bed lies under it"
                                                        : "is the bed: the release lies on top of it");
    line("particles", grouped(expected.particles));
    line("memory", words("about", bytes_text(static_cast<double>(expected.memory_bytes))));
    line("fields", std::to_string(expected.bytes_per_particle) + " bytes a particle, " +
                       std::to_string(expected.bytes_per_node) + " bytes a node");
    line("first step", figure(expected.first_step_seconds, 3) + " s, end at " +
                           shortest_text(prepared.scene.time.end) + " s at most");
    line("estimated time",
         words("about", figure(expected.wall_seconds, 2)) + " s on " + std::to_string(threads) + " threads");
    for (std::size_t i = 0; i < expected.terms.size(); ++i) line(i == 0 ? "terms" : "", expected.terms[i]);
    line("result", output_directory(prepared.spec));
}

}  // namespace

int cmd_check(const Arguments& arguments) {
    const auto values = parse_arguments(check_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const int threads = thread_count(*values);
    RunLog log(false);
    const SceneReading reading = read_scene((*values)["operand"].as<std::string>(),
                                            text_options(*values, "set"), materials_directory());
    const Prepared prepared = prepare(reading, log);
    const RunEstimate expected = estimate(prepared.scene, threads);
    std::printf("Scene %s is ready to run.\n", reading.scene.file.c_str());
    print_inputs(prepared);
    print_run(prepared, expected, threads);
    std::fflush(stdout);
    compare_volumes(prepared.release.file_volume_m3, expected.volume, log);
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
