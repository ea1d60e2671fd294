// SPDX-License-Identifier: Apache-2.0
#include "app/commands/check_document.h"

#include <nlohmann/json.hpp>

#include "app/commands/json_output.h"
#include "app/input/transform_report.h"
#include "app/store/result_place.h"

namespace frana::app {
namespace {

Json bounds_json(const Bounds& box) {
    return Json::array({box.west, box.south, box.east, box.north});
}

Json ground_json(const std::optional<GroundStatistics>& ground) {
    if (!ground) return {};
    return {{"lowest_m", ground->lowest},
            {"highest_m", ground->highest},
            {"mean_slope_deg", ground->mean_slope_deg},
            {"steepest_slope_deg", ground->steepest_slope_deg}};
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

}  // namespace

Json check_document(const CheckedScene& checked) {
    const Prepared& prepared = checked.prepared;
    const RunEstimate& expected = checked.expected;
    const GridSpec& grid = prepared.scene.grid;
    Json json = document_of("check");
    json["scene"] = prepared.spec.file;
    json["warnings"] = texts_of(checked.warnings);
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
                       {"area_m2", prepared.release.area_m2},
                       {"inflow_m3", expected.inflow},
                       {"dtm_contains_release", prepared.scene.terrain_contains_release},
                       {"ground", ground_json(prepared.release.ground)}};
    const auto& trial = checked.trial;
    const double engine = engine_seconds(expected, trial);
    json["run"] = {{"particles", expected.particles},
                   {"particles_at_most", trial ? Json(trial->particles_peak) : Json()},
                   {"memory_bytes", checked.memory_bytes},
                   {"first_step_s", expected.first_step_seconds},
                   {"end_s", prepared.scene.time.end},
                   {"threads", checked.threads},
                   {"estimated_seconds", engine + checked.writing.seconds},
                   {"engine_seconds", engine},
                   {"disk_bytes", checked.writing.disk_bytes},
                   {"estimate_is_lower_bound", !trial.has_value()},
                   {"path", trial ? ground_json(trial->path) : Json()},
                   {"terms", expected.terms}};
    const std::string place = result_path(checked.result);
    json["result"] = {{"folder", place}, {"exists", has_files(place)}};
    return json;
}

}  // namespace frana::app
