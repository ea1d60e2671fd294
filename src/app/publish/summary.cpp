// SPDX-License-Identifier: Apache-2.0
#include "app/publish/summary.h"

#include <sys/resource.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/store/scene_identity.h"
#include "app/text/version.h"
#include "core/json.h"
#include "simulation/run_check.h"
#include "simulation/run_statistics.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// If nothing ever flowed the greatest value is 0; if nothing is deeper than the threshold the others are null.
void add_peak_statistics(Json& json, const PeakStatistics& high) {
    for (std::size_t i = 0; i < high.size(); ++i) {
        const std::string name = k_peak_statistics[i].name, unit = std::string("_") + k_peak_statistics[i].key_unit;
        json[name + unit] = std::isnan(high[i].greatest) ? 0 : high[i].greatest;
        json[name + "_p999" + unit] = high[i].p999;
        json[name + "_p99" + unit] = high[i].p99;
    }
}

void add_grid_and_particles(Json& json, const RunResult& result, const SummaryFacts& facts) {
    const GridSpec& grid = result.max_depth.grid;
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
    json["particles"] = {
        {"initial", result.particles_initial}, {"final", result.particles_final}, {"peak", result.particles_peak}};
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

Json phases_json(const PhaseBudget& budget) {
    const auto volumes = [](const PhaseVolumes& v) {
        return Json{{"solids_m3", v.solids}, {"confined_water_m3", v.confined}, {"free_water_m3", v.free}};
    };
    return {{"entered", volumes(budget.entered)},    {"inside", volumes(budget.inside)},
            {"left_domain", volumes(budget.left)},   {"released_water_m3", budget.released},
            {"cohesion_left", budget.cohesion_left}, {"rms_velocity_difference_ms", budget.rms_apart}};
}

Json volume_json(const RunResult& result) {
    Json volume{{"initial_m3", result.volume_initial},
                {"entered_m3", result.volume_entered},
                {"inflow_m3", result.volume_inflow},
                {"final_m3", result.volume_final},
                {"final_depth_raster_m3", shown_volume(result)},
                {"greatest_thin_fraction", result.thin_fraction},
                {"left_domain_m3", result.volume_left}};
    if (result.exchanges) {
        volume["eroded_m3"] = result.volume_eroded;
        volume["deposited_m3"] = result.volume_deposited;
    }
    volume["relative_error"] = relative_volume_error(result);
    return volume;
}

void add_flow(Json& json, const RunResult& result, const SummaryFacts& facts) {
    json["volume"] = volume_json(result);
    if (result.phases) json["phases"] = phases_json(*result.phases);
    if (result.exchanges) json["deposited_momentum_kg_m_s"] = result.momentum_deposited;
    if (curvature(facts.spec.numerics)) json["unsupported_node_steps"] = result.unsupported;
    if (result.jumps) {
        const RunResult::Jumps& jumps = *result.jumps;
        json["jumps"] = {{"volume_m3", jumps.volume},      {"highest_m", jumps.highest},
                         {"mean_length_m", jumps.mean},    {"longest_m", jumps.longest},
                         {"longest_from_x", jumps.from.x}, {"longest_from_y", jumps.from.y},
                         {"longest_to_x", jumps.to.x},     {"longest_to_y", jumps.to.y}};
    }
    Json& areas = json["release_areas"] = Json::array();
    for (const ReleasedArea& area : result.released)
        areas.push_back({{"name", area.name},
                         {"start_s", area.start},
                         {"area_m2", area.area},
                         {"volume_m3", area.volume},
                         {"thickness_scaled_by", area.scaled},
                         {"failed", area.failed}});
    if (result.energy_error) json["energy_error"] = *result.energy_error;
}

Json runout_json(const Runout& one) {
    return {{"horizontal_m", one.horizontal_m}, {"drop_m", one.drop_m}, {"reach_angle_deg", one.reach_angle_deg}};
}

void add_ground(Json& json, const char* where, const std::optional<GroundStatistics>& ground) {
    if (!ground) return;
    json["ground"][where] = {{"lowest_m", ground->lowest},
                             {"highest_m", ground->highest},
                             {"mean_slope_deg", ground->mean_slope_deg},
                             {"steepest_slope_deg", ground->steepest_slope_deg}};
}

void add_trace(Json& json, const SummaryFacts& facts) {
    add_ground(json, "release", facts.release_ground);
    add_ground(json, "path", facts.path_ground);
    add_peak_statistics(json, facts.high);
    json["covered_area_m2"] = facts.statistics.covered_area_m2;
    json["trace_threshold_m"] = facts.statistics.threshold;
    json["runout"] = runout_json(facts.statistics.run_out());
    Json& flows = json["flows"] = Json::array();
    for (const Runout& one : facts.statistics.run_outs) {
        flows.push_back(runout_json(one));
        flows.back().update({{"covered_area_m2", one.covered_area_m2},
                             {"top_x", one.top.x},
                             {"top_y", one.top.y},
                             {"tip_x", one.tip.x},
                             {"tip_y", one.tip.y}});
    }
    for (const HazardArea& area : facts.hazard)
        json["hazard"].push_back({{"class", area.kind.value},
                                  {"label", area.kind.name},
                                  {"thresholds", area.kind.thresholds},
                                  {"area_m2", area.area_m2}});
    if (facts.exposure) json["exposure"] = exposure_json(*facts.exposure);
}

void add_run_problems(Json& json, const RunResult& result) {
    const HardEvents& events = result.hard_events;
    json["hard_events"] = {{"non_finite", events.non_finite},
                           {"depth_clamped", events.depth_clamped},
                           {"entered_no_data", events.entered_no_data},
                           {"impossible_speed", events.impossible_speed},
                           {"volume_drift", events.volume_drift}};
    Json& run_problems = json["problems"] = Json::array();
    for (const RunProblem& run_problem : result.run_problems) {
        Json& one = run_problems.emplace_back(Json{{"step", run_problem.step}, {"time_s", run_problem.time}});
        if (run_problem.place) {
            one["x"] = run_problem.place->x;
            one["y"] = run_problem.place->y;
        }
        one["what"] = describe(run_problem);
    }
}

}  // namespace

std::string stop_word(StopReason reason) {
    switch (reason) {
        case StopReason::still:
            return "still";
        case StopReason::settled:
            return "settled";
        case StopReason::energy:
            return "energy";
        case StopReason::moving_volume:
            return "moving-volume";
        case StopReason::all_left:
            return "all-left";
        case StopReason::requested:
            return "requested";
        case StopReason::reached_no_data:
            return "reached-no-data";
        case StopReason::non_finite:
            return "non-finite";
        case StopReason::impossible_speed:
            return "impossible-speed";
        case StopReason::volume_drift:
            return "volume-drift";
        case StopReason::end_time:
            break;
    }
    return "end-time";
}

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
            {"count_reached", totals.count_reached}};
}

std::string summary_json(const RunResult& result, const SummaryFacts& facts) {
    Json json{{"program", k_program},
              {"version", k_version},
              {"format", k_result_format},
              {"date", facts.date},
              {"scene", facts.spec.file},
              {"model", facts.spec.material.model},
              {"scheme", facts.spec.numerics.scheme},
              {"slope_correction", slope_correction(facts.spec.numerics)},
              {"crs", facts.crs_label},
              {"threads", facts.threads},
              {"steps", result.steps},
              {"simulated_seconds", result.simulated_seconds},
              {"stop_reason", stop_word(result.stop_reason)},
              {"stop_reason_text", describe(result.stop_reason)},
              {"moving_fraction", result.moving_fraction_limit}};
    if (result.settling) {
        const Settling& s = *result.settling;
        json["settling"] = {{"window_s", s.window},
                            {"runout_growth_m", s.runout},
                            {"area_growth", s.area},
                            {"deposit_change", s.deposit},
                            {"stop_change", facts.spec.time.stop_change},
                            {"stop_window", facts.spec.time.stop_window}};
    }
    add_grid_and_particles(json, result, facts);
    json["terms"] = result.terms;
    add_cost(json, result, facts);
    add_flow(json, result, facts);
    add_trace(json, facts);
    add_run_problems(json, result);
    if (facts.accuracy) json["accuracy"] = accuracy_json(*facts.accuracy);
    json["warnings"] = facts.warnings;
    json[k_data_key] = facts.data_identity;
    return json_text(json);
}

}  // namespace frana::app
