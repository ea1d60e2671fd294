// SPDX-License-Identifier: Apache-2.0
#include "app/publish/summary.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "app/store/scene_identity.h"
#include "app/text/version.h"
#include "core/json.h"

namespace frana::app {
namespace {

void add_grid_and_particles(Json& json, const RunResult& result, const SummaryFacts& facts) {
    const GridSpec& grid = result.raster("max_depth").grid;
    json["grid"] = {{"columns", grid.columns},
                    {"rows", grid.rows},
                    {"cell_size", grid.cell_size},
                    {"west", grid.west},
                    {"north", grid.north}};
    if (!grid.same_cells(facts.computed)) {
        json["map"] = {{"columns", facts.computed.columns},
                       {"rows", facts.computed.rows},
                       {"west", facts.computed.west},
                       {"north", facts.computed.north}};
    }
    add_particles(json, result);
}

void add_hazard(Json& json, const SummaryFacts& facts) {
    for (const HazardArea& area : facts.hazard)
        json["hazard"].push_back({{"class", area.kind.value},
                                  {"label", area.kind.name},
                                  {"thresholds", area.kind.thresholds},
                                  {"area_m2", area.area_m2}});
    if (facts.exposure) json["exposure"] = exposure_json(*facts.exposure);
}

void add_cost(Json& json, const RunResult& result, const SummaryFacts& facts) {
    json["wall_seconds"] = {{"total", facts.wall.total},
                            {"input", facts.wall.input},
                            {"engine", facts.wall.engine},
                            {"output", facts.wall.output},
                            {"render", facts.wall.render}};
    json["particle_steps"] = result.particle_steps;
    json["particle_steps_per_second"] =
        facts.wall.engine > 0 ? static_cast<double>(result.particle_steps) / facts.wall.engine : 0;
    json["bytes_per_particle"] = result.bytes_per_particle;
    json["bytes_per_node"] = result.bytes_per_node;
    json["peak_memory_bytes"] = facts.peak_memory_bytes;
}

}  // namespace

std::int64_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

Json exposure_json(const ExposureTotals& totals) {
    return {{"features", totals.features},
            {"reached", totals.reached},
            {"off_map", totals.off_map},
            {"count", totals.count},
            {"count_reached", totals.count_reached},
            {"lower_bound", totals.is_least}};
}

std::string summary_json(const RunResult& result, const SummaryFacts& facts) {
    Json json{{"program", k_program},
              {"version", k_version},
              {"format", k_result_format},
              {"date", facts.date},
              {"scene", facts.spec.file},
              {"model", facts.spec.material.model},
              {"scheme", word_of(facts.spec.numerics.scheme, k_schemes)},
              {"slope_correction", word_of(slope_correction(facts.spec.numerics), k_slope_corrections)},
              {"crs", facts.crs_label},
              {"threads", facts.threads}};
    add_end(json, result, facts.spec);
    json["held_by_no_data"] = facts.statistics.end && facts.statistics.end->is_held;
    add_grid_and_particles(json, result, facts);
    json["terms"] = result.terms;
    add_cost(json, result, facts);
    add_flow(json, result, facts.spec);
    const MainStatistics& trace = facts.statistics;
    add_trace(json, {trace.threshold, trace.covered_area_m2, trace.run_outs, facts.high, facts.release_ground,
                     facts.path_ground});
    add_hazard(json, facts);
    add_run_problems(json, result);
    if (facts.accuracy) json["accuracy"] = accuracy_json(*facts.accuracy);
    json["warnings"] = texts_of(facts.warnings);
    json[k_data_key] = facts.data_identity;
    return json_text(json);
}

}  // namespace frana::app
