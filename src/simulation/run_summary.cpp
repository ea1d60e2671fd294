// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/runout.h"
#include "analysis/trace.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_check.h"
#include "simulation/simulation.h"

namespace frana {

const Raster* RunResult::find_raster(const std::string& name) const noexcept {
    const auto found =
        std::find_if(rasters.begin(), rasters.end(), [&](const NamedRaster& one) { return one.name == name; });
    return found == rasters.end() ? nullptr : &found->values;
}

const Raster& RunResult::raster(const std::string& name) const {
    const Raster* const found = find_raster(name);
    if (found == nullptr) throw std::out_of_range("the run made no raster " + name);
    return *found;
}

ReachedPlaces::ReachedPlaces(const RunResult& result) : result_(result) {
    for (const NamedRaster& low : result.low_flights) {
        const Raster* const on_ground = result.find_raster(low.name);
        if (on_ground == nullptr) continue;
        Raster& both = with_flights_.emplace(low.name, *on_ground).first->second;
        const bool is_least = low.name == RasterName::arrival_time;
        low.values.values.for_each_stored([&](std::size_t cell, double value) {
            const double before = std::as_const(both).values[cell];
            if (!std::isnan(value)) both.values[cell] = is_least ? std::fmin(before, value) : std::fmax(before, value);
        });
    }
}

const Raster& ReachedPlaces::operator()(const std::string& name) const {
    const auto found = with_flights_.find(name);
    return found != with_flights_.end() ? found->second : result_.raster(name);
}

Raster intensity_classes(const RunResult& result, const HazardScheme& scheme) {
    const ReachedPlaces reached(result);
    // For a scheme without flux or head none is recorded; depth is passed instead and not read.
    const auto recorded = [&](const char* name) -> const Raster& {
        return reached(result.find_raster(name) ? name : RasterName::max_depth);
    };
    return hazard_classes(
        scheme, {reached(RasterName::max_depth), reached(RasterName::max_velocity), recorded(RasterName::max_flux),
                 recorded(RasterName::max_head), reached(RasterName::max_pressure),
                 result.raster(RasterName::final_depth), recorded(RasterName::max_momentum_flux)});
}

namespace {

/// A value at a place with a name.
struct PlaceValue {
    const char *kind, *key;  ///< "gauge NAME: max_depth_m"
    const char *title, *unit;

    [[nodiscard]] std::string before() const { return std::string(kind) + " "; }
    [[nodiscard]] std::string after() const { return std::string(": ") + key; }
    [[nodiscard]] RunValue at(const std::string& name, double value, double negligible) const {
        return {before() + name + after(), worded("{1}: {2}", {name, Sentence(title)}), unit, value, 0, negligible};
    }
};
constexpr PlaceValue k_gauge_depth{"gauge", "max_depth_m", worded("Maximum depth"), "m"},
    k_gauge_speed{"gauge", "max_speed_ms", worded("Maximum velocity"), "m/s"},
    k_section_discharge{"section", "max_discharge_m3s", worded("Maximum discharge"), "m3/s"},
    k_section_volume{"section", "volume_m3", worded("Volume"), "m3"};

void add_gauges(const RunResult& result, const Scene& scene, std::vector<RunValue>& values) {
    const std::vector<Gauge>& gauges = scene.recording.gauges;
    std::vector<double> depth(gauges.size()), speed(gauges.size());
    for (const GaugeRow& row : result.gauges) {
        depth[row.gauge] = std::max(depth[row.gauge], row.depth);
        speed[row.gauge] = std::max(speed[row.gauge], row.speed);
    }
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        const std::string& name = gauges[i].name;
        values.push_back(k_gauge_depth.at(name, depth[i], scene.numerics.minimum_depth));
        values.push_back(k_gauge_speed.at(name, speed[i], scene.time.moving_speed));
    }
}

void add_sections(const RunResult& result, const Scene& scene, std::vector<RunValue>& values) {
    const std::vector<CrossSection>& sections = scene.recording.sections;
    std::vector<double> discharge(sections.size()), volume(sections.size());
    for (const SectionRow& row : result.sections) {
        discharge[row.section] = std::max(discharge[row.section], std::abs(row.discharge));
        volume[row.section] = row.volume;
    }
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::string& name = sections[i].name;
        values.push_back(k_section_discharge.at(name, discharge[i], 0));
        values.push_back(k_section_volume.at(name, volume[i], 0));
    }
}

/// Whether a key is that of a value at a gauge or cross-section.
bool is_at_place(const std::string& key) {
    for (const PlaceValue& one : {k_gauge_depth, k_gauge_speed, k_section_discharge, k_section_volume}) {
        const std::string before = one.before(), after = one.after();
        if (key.size() >= before.size() + after.size() && key.starts_with(before) && key.ends_with(after)) return true;
    }
    return false;
}

}  // namespace

std::vector<RunValue> reported_values(const RunResult& result, const Scene& scene, double threshold) {
    const RunStatistics statistics = run_statistics(result, threshold);
    std::vector<RunValue> values;
    for (const RunStatistic& row : k_run_statistics) {
        if (!is_reported(row)) continue;
        const double value = row.of(statistics);
        const bool is_run_out = std::string_view(row.key) == k_run_out_key;
        values.push_back({row.key, row.title, row.unit, std::isnan(value) ? 0 : value,
                          is_run_out ? result.raster(RasterName::max_depth).grid.cell_size : 0, 0});
    }
    add_gauges(result, scene, values);
    add_sections(result, scene, values);
    return values;
}

bool is_value_key(const std::string& key) {
    return std::any_of(std::begin(k_run_statistics), std::end(k_run_statistics),
                       [&](const RunStatistic& row) { return key == row.key; }) ||
           is_at_place(key);
}

RunStatistics run_statistics(const RunResult& result, double threshold) {
    const Raster& depth = result.raster(RasterName::max_depth);
    const Raster trace = trace_mask(depth, threshold);
    return {high_values(depth, trace), high_values(result.raster(RasterName::max_velocity), trace), masked_area(trace),
            runouts(separate_flows(result), result.raster(RasterName::bed), result.raster("release"), trace)
                .front()
                .horizontal_m,
            result.volume_final > 0 ? result.volume_shown / result.volume_final : k_no_data};
}

SeparateFlows separate_flows(const RunResult& result) {
    return {result.raster("release"), result.raster(RasterName::max_depth), result.inflow_places};
}

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

/// Where the greatest values are and, of those in the series, when.
void add_peak_places(Json& json, const RunResult& result) {
    for (const PeakStatistic& what : k_peak_statistics) {
        const Raster& raster = result.raster(what.name);
        std::optional<std::size_t> highest;
        raster.values.for_each_stored([&](std::size_t cell, double value) {
            if (!std::isnan(value) && (!highest || value > raster.values[*highest])) highest = cell;
        });
        if (!highest || result.series.empty()) continue;
        const std::int64_t columns = raster.grid.columns, cell = static_cast<std::int64_t>(*highest);
        const Point place = raster.grid.cell_centre(cell / columns, cell % columns);
        const double SeriesRow::*const over_time =
            &raster == &result.raster(RasterName::max_depth) ? &SeriesRow::max_depth : &SeriesRow::max_speed;
        const auto row = std::max_element(
            result.series.begin(), result.series.end(),
            [over_time](const SeriesRow& a, const SeriesRow& b) { return a.*over_time < b.*over_time; });
        json[std::string(what.name) + "_at"] = {{"time_s", row->time}, {"x", place.x}, {"y", place.y}};
    }
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
                {"final_depth_raster_m3", result.volume_shown},
                {"greatest_thin_fraction", result.thin_fraction},
                {"left_domain_m3", result.volume_left}};
    if (result.exchanges) {
        volume["eroded_m3"] = result.volume_eroded;
        volume["deposited_m3"] = result.volume_deposited;
    }
    if (result.volume_detrained > 0) volume["detrained_m3"] = result.volume_detrained;
    if (result.volume_rained > 0) volume["rain_m3"] = result.volume_rained;
    if (result.volume_infiltrated > 0) volume["infiltrated_m3"] = result.volume_infiltrated;
    volume["relative_error"] = relative_volume_error(result);
    return volume;
}

Json runout_json(const Runout& one) {
    Json json{{"horizontal_m", one.horizontal_m}, {"drop_m", one.drop_m}, {"reach_angle_deg", one.reach_angle_deg}};
    if (one.path_m > 0) json.update({{"path_m", one.path_m}, {"path_angle_deg", one.path_angle_deg()}});
    if (one.beta_deg > 0)
        json.update({{"beta_deg", one.beta_deg},
                     {"alpha_beta_deg", one.alpha_deg()},
                     {"alpha_beta_deviation_deg", Runout::k_alpha_deviation}});
    return json;
}

}  // namespace

Json ground_json(const GroundStatistics& ground) {
    return {{"lowest_m", ground.lowest},
            {"highest_m", ground.highest},
            {"mean_slope_deg", ground.mean_slope_deg},
            {"steepest_slope_deg", ground.steepest_slope_deg}};
}

TraceFigures trace_figures(const RunResult& result, const Raster& terrain, double threshold) {
    const Raster trace = trace_mask(result.raster(RasterName::max_depth), threshold);
    TraceFigures figures;
    figures.threshold = threshold;
    figures.covered_area_m2 = masked_area(trace);
    figures.run_outs = runouts(separate_flows(result), result.raster(RasterName::bed), result.raster("release"), trace);
    if (Runout& first = figures.run_outs.front(); first.horizontal_m > 0) {
        const Polyline path = flow_path(result.raster(RasterName::max_depth), first.top, first.tip);
        const Raster& bed = result.raster(RasterName::bed);
        first.path_m = length(path);
        first.beta_deg = beta_of(path, bed, cell_value(bed, first.tip) + first.drop_m);
    }
    figures.high = peak_statistics(result, trace);
    figures.path_ground = ground_where(terrain, trace, 0);
    return figures;
}

std::string stop_word(StopReason reason) {
    switch (reason) {
        case StopReason::still:
            return "still";
        case StopReason::settled:
            return "settled";
        case StopReason::momentum:
            return "momentum";
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

MotionAtEnd motion_at_end(StopReason reason, double fastest, double moving_fraction, bool front_is_final,
                          double deposit_change) noexcept {
    constexpr double k_moving_speed = 0.1;    // [m/s]
    constexpr double k_moving_volume = 0.01;  // however thin it moves
    // What has settled has a final deposit as well, but for a loose time.stop-change.
    const bool has_settled = reason == StopReason::settled;
    front_is_final = front_is_final && (has_settled ? deposit_change : moving_fraction) <= k_creeping_volume;
    const bool moves =
        (has_settled || ends_in_motion(reason)) && (fastest > k_moving_speed || moving_fraction > k_moving_volume);
    return {moves && !front_is_final, moves && front_is_final};
}

MotionAtEnd motion_at_end(const RunResult& result) noexcept {
    return motion_at_end(result.stop_reason, result.series.empty() ? 0 : result.series.back().max_speed,
                         result.moving_fraction_limit, result.settling && result.settling->front_is_final,
                         result.settling ? result.settling->deposit : 0);
}

GapContact gap_contact(const RunResult& result, const Scene& scene, NodataPolicy policy) {
    GapContact gap;
    const Raster& deepest = result.raster(RasterName::max_depth);
    if (scene.numerics.nodata != policy || !deepest.grid.same_cells(scene.terrain.grid)) return gap;
    const GridSpec& grid = deepest.grid;
    const Raster& terrain = scene.terrain;
    const auto touches_gap = [&](std::int64_t row, std::int64_t column) {
        for (std::int64_t r = std::max<std::int64_t>(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
            for (std::int64_t c = std::max<std::int64_t>(column - 1, 0); c <= std::min(column + 1, grid.columns - 1);
                 ++c)
                if (!terrain.has_data(r, c)) return true;
        return false;
    };
    deepest.values.for_each_stored([&](std::size_t cell, double depth) {
        const auto place = static_cast<std::int64_t>(cell);
        if (!(depth > 0) || !touches_gap(place / grid.columns, place % grid.columns)) return;
        ++gap.cells;
        gap.depth = std::max(gap.depth, depth);
    });
    return gap;
}

double left_fraction(const RunResult& result) noexcept {
    const double rained = result.volume_rained, entered = result.volume_entered - rained;
    const double fraction = entered > 0 ? std::max(0.0, result.volume_left - rained) / entered : 0;
    if (rained == 0 || !result.phases || !(result.phases->entered.solids > 0)) return fraction;
    return std::max(fraction, result.phases->left.solids / result.phases->entered.solids);
}

bool is_open(const RunResult& result, const Scene& scene) {
    return motion_at_end(result).front || left_ground(result) || !result.run_problems.empty() ||
           gap_contact(result, scene).cells > 0;
}

void add_end(Json& json, const RunResult& result, const SceneSpec& spec) {
    json["steps"] = result.steps;
    json["simulated_seconds"] = result.simulated_seconds;
    json["stop_reason"] = stop_word(result.stop_reason);
    json["stop_reason_text"] = describe(result.stop_reason);
    json["moving_fraction"] = result.moving_fraction_limit;
    if (result.settling) {
        const Settling& s = *result.settling;
        json["settling"] = {{"window_s", s.window},
                            {"runout_growth_m", s.runout},
                            {"area_growth", s.area},
                            {"front_is_final", s.front_is_final},
                            {"deposit_change", s.deposit},
                            {"deposit_error", s.deposit_error},
                            {"stop_change", spec.time.stop_change},
                            {"stop_window", spec.time.stop_window}};
    }
}

void add_particles(Json& json, const RunResult& result) {
    json["particles"] = {
        {"initial", result.particles_initial}, {"final", result.particles_final}, {"peak", result.particles_peak}};
}

void add_flow(Json& json, const RunResult& result, const SceneSpec& spec) {
    json["volume"] = volume_json(result);
    if (result.phases) json["phases"] = phases_json(*result.phases);
    if (result.exchanges) json["deposited_momentum_kg_m_s"] = result.momentum_deposited;
    if (curvature(spec.numerics)) json["unsupported_node_steps"] = result.unsupported;
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
    json["depth_direction"] = result.depth_is_normal ? k_normal : k_vertical;
    add_peak_places(json, result);
}

void add_trace(Json& json, const TraceFigures& trace) {
    if (trace.release_ground) json["ground"]["release"] = ground_json(*trace.release_ground);
    if (trace.path_ground) json["ground"]["path"] = ground_json(*trace.path_ground);
    add_peak_statistics(json, trace.high);
    json["covered_area_m2"] = trace.covered_area_m2;
    json["trace_threshold_m"] = trace.threshold;
    json["runout"] = runout_json(trace.run_outs.front());
    Json& flows = json["flows"] = Json::array();
    for (const Runout& one : trace.run_outs) {
        flows.push_back(runout_json(one));
        flows.back().update({{"covered_area_m2", one.covered_area_m2},
                             {"top_x", one.top.x},
                             {"top_y", one.top.y},
                             {"tip_x", one.tip.x},
                             {"tip_y", one.tip.y}});
    }
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

}  // namespace frana
