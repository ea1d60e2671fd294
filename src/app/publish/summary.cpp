// SPDX-License-Identifier: Apache-2.0
#include "app/publish/summary.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/json.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

std::vector<const AccuracyLevel*> completed(const AccuracyRecord& record) {
    std::vector<const AccuracyLevel*> levels;
    for (const AccuracyLevel& level : record.levels)
        if (level.problem.empty()) levels.push_back(&level);
    return levels;
}

Json level_json(const AccuracyLevel& level) {
    Json json{{"cell_size_m", level.cell_size},
              {"particles", level.particles},
              {"steps", level.steps},
              {"engine_seconds", level.wall_seconds},
              {"ground_curvature_per_m", level.curvature},
              {"ground_curvature_on_finest_per_m", level.finest_curvature}};
    if (!level.problem.empty()) json["problem"] = level.problem;
    for (const RunValue& value : level.values) json["values"][value.key] = value.value;
    return json;
}

std::string cells(double size) {
    return number_text(size) + " m";
}

/// Percent of the value, or its unit where that is zero.
Sentence error_text(const ValueEstimate& estimate) {
    if (!std::isfinite(estimate.error)) return worded("not converging");
    const bool has_percent = std::isfinite(estimate.percent());
    return numeral(number_text(has_percent ? estimate.percent() : estimate.error, 2) + " " +
                   (has_percent ? "%" : estimate.value.unit));
}

// The same in all languages.
constexpr const char *k_listed = "{1}, {2}", *k_bracketed = "{1} ({2})";

/// States the cell size of the result and of its terrain.
Sentence cells_sentence(const AccuracyRecord& record) {
    const Sentence own = worded("cells of {1} m", {numeral(number_text(record.chosen_cell_size))});
    if (!(record.chosen_cell_size < record.terrain_cell_size * (1 - 1e-9))) return own;
    return worded(k_listed,
                  {own, worded("finer than the DTM's {1} m", {numeral(number_text(record.terrain_cell_size))})});
}

}  // namespace

double ValueEstimate::percent() const {
    if (error == 0) return 0;
    return value.value != 0 ? 100 * error / std::abs(value.value) : std::numeric_limits<double>::infinity();
}

std::vector<ValueEstimate> value_estimates(const AccuracyRecord& record) {
    const std::vector<const AccuracyLevel*> levels = completed(record);
    std::vector<double> sizes;
    for (const AccuracyLevel* level : levels) sizes.push_back(level->cell_size);
    if (levels.empty() || !enough_levels(sizes)) return {};
    const AccuracyLevel& last = *levels.back();
    const double detail = unseen_detail(last.curvature, last.finest_curvature);
    std::vector<std::vector<Refinement>> values(last.values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (const AccuracyLevel* level : levels) values[i].push_back({level->cell_size, level->values.at(i).value});
    const std::vector<GridConvergence> convergence = grid_convergence(values, detail);
    std::vector<ValueEstimate> estimates;
    for (std::size_t i = 0; i < values.size(); ++i) {
        ValueEstimate estimate;
        estimate.value = last.values[i];
        estimate.is_zero =
            std::all_of(values[i].begin(), values[i].end(), [](const Refinement& level) { return level.value == 0; });
        estimate.convergence = convergence[i];
        estimate.error = std::max(estimate.convergence.error, estimate.value.resolution);
        estimate.allowed = std::max(record.asked * std::abs(estimate.value.value), estimate.value.negligible);
        estimates.push_back(std::move(estimate));
    }
    return estimates;
}

bool is_reached(const std::vector<ValueEstimate>& estimates) {
    return !estimates.empty() && std::all_of(estimates.begin(), estimates.end(),
                                             [](const ValueEstimate& e) { return e.is_zero || e.is_within(); });
}

std::string record_text(const AccuracyRecord& record) {
    Json json{{"asked", record.asked},
              {"finest", record.finest_cell_size},
              {"terrain", record.terrain_cell_size},
              {"chosen", record.chosen_cell_size},
              {"levels", Json::array()}};
    for (const AccuracyLevel& level : record.levels) {
        Json values = Json::array();
        for (const RunValue& v : level.values)
            values.push_back({v.key, json_of(v.title), v.unit, v.value, v.resolution, v.negligible});
        json["levels"].push_back({level.cell_size, level.particles, level.steps, level.wall_seconds, level.curvature,
                                  level.finest_curvature, std::move(values), level.problem});
    }
    return json_text(json);
}

AccuracyRecord record_from_text(const std::string& text) try {
    const Json json = Json::parse(text);
    AccuracyRecord record{json.at("asked"), json.at("finest"), json.at("terrain"), json.at("chosen"), {}};
    for (const Json& row : json.at("levels")) {
        AccuracyLevel level{row.at(0), row.at(1), row.at(2), row.at(3), row.at(4), row.at(5), {}, row.at(7)};
        for (const Json& v : row.at(6))
            level.values.push_back({v.at(0), sentence_in(v.at(1)), v.at(2), v.at(3), v.at(4), v.at(5)});
        record.levels.push_back(std::move(level));
    }
    return record;
} catch (const Json::exception& error) {
    throw Error(ErrorKind::input, Problem{std::string("is no record of levels: ") + error.what(), "checkpoint", "", "",
                                          "Start again with --overwrite"});
}

Json accuracy_json(const AccuracyRecord& record) {
    const std::vector<ValueEstimate> estimates = value_estimates(record);
    Json json{{"asked", record.asked},
              {"reached", is_reached(estimates)},
              {"verdict", accuracy_verdict(record).text()},
              {"cell_size_m", record.chosen_cell_size},
              {"finest_cell_size_m", record.finest_cell_size},
              {"dtm_cell_size_m", record.terrain_cell_size},
              {"levels", Json::array()},
              {"values", Json::array()}};
    for (const AccuracyLevel& level : record.levels) json["levels"].push_back(level_json(level));
    for (const ValueEstimate& e : estimates) {
        json["values"].push_back({{"key", e.value.key},
                                  {"title", e.value.title.text()},
                                  {"unit", e.value.unit},
                                  {"value", e.value.value},
                                  {"estimated_error", e.error},
                                  {"estimated_error_percent", e.percent()},
                                  {"allowed_error", e.allowed},
                                  {"within", e.is_within()},
                                  {"zero_on_all_levels", e.is_zero},
                                  {"trend", describe(e.convergence.trend)},
                                  {"observed_order", e.convergence.observed_order}});
    }
    return json;
}

std::string percent_text(double fraction) {
    return number_text(100 * fraction, 3) + " %";
}

std::string level_table(const AccuracyRecord& record) {
    std::string text;
    for (const AccuracyLevel& level : record.levels) {
        text += "  cells of " + cells(level.cell_size) + ": ";
        if (level.problem.empty()) {
            text += (level.particles > 0 ? grouped(level.particles) + " particles, " : "finite volumes, ") +
                    grouped(level.steps) + " steps, " + number_text(level.wall_seconds, 3) + " s\n";
        } else {
            text += level.problem + "\n";
        }
    }
    return text;
}

std::string estimate_lines(const std::vector<ValueEstimate>& estimates) {
    std::string text;
    for (const ValueEstimate& e : estimates) {
        if (e.is_zero) {
            text += "  " + e.value.title.text() + " 0 " + e.value.unit + " on all levels: no estimate\n";
            continue;
        }
        const bool is_stated = std::isfinite(e.error);
        text += "  " + e.value.title.text() + " " + number_text(e.value.value) + " " + e.value.unit +
                (is_stated ? ", estimated error " + number_text(e.error, 2) + " " + e.value.unit : ", not converged");
        if (is_stated && e.value.value != 0) text += " (" + number_text(e.percent(), 2) + " %)";
        text += std::string("; ") + describe(e.convergence.trend);
        if (!std::isnan(e.convergence.observed_order))
            text += ", order " + number_text(e.convergence.observed_order, 2);
        text += e.is_within() ? "\n" : "; not claimed\n";
    }
    if (!text.empty()) text.pop_back();
    return text;
}

Sentence accuracy_verdict(const AccuracyRecord& record) {
    const std::vector<ValueEstimate> estimates = value_estimates(record);
    const Sentence asked = numeral("numerics.accuracy = " + percent_text(record.asked)),
                   result = cells_sentence(record);
    if (estimates.empty()) return worded("{1} not estimated, too few coarser levels; {2}", {asked, result});
    const std::string all = std::to_string(
        std::count_if(estimates.begin(), estimates.end(), [](const ValueEstimate& e) { return !e.is_zero; }));
    const Sentence rest = listed({result, worded("discretisation error only")});
    if (is_reached(estimates)) return listed({worded("{1} met by {2} of {3} values", {asked, all, all}), rest});
    constexpr std::size_t k_named = 4;
    Sentence named;
    std::size_t unmet = 0;
    const auto name = [&](const Sentence& one) { named = unmet == 1 ? one : worded(k_listed, {named, one}); };
    for (const ValueEstimate& e : estimates) {
        if (e.is_zero || e.is_within()) continue;
        if (++unmet <= k_named) name(worded(k_bracketed, {e.value.title, error_text(e)}));
    }
    if (unmet > k_named) name(std::string("…"));
    const Sentence missed = worded("{1} not met by {2} of {3} values", {asked, std::to_string(unmet), all});
    return listed({worded("{1}: {2}", {missed, named}), rest});
}

namespace {

void add_grid_and_particles(Json& json, const RunResult& result, const SummaryFacts& facts) {
    const GridSpec& grid = result.raster(RasterName::max_depth).grid;
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
    if (const auto& scheme = facts.scheme)
        json["hazard_scheme"] = {{"name", scheme->name},
                                 {"title", scheme->called},
                                 {"source", scheme->source},
                                 {"source_read", scheme->is_source_read()}};
    for (const HazardArea& area : facts.hazard)
        json["hazard"].push_back({{"class", area.kind.value},
                                  {"label", area.kind.name},
                                  {"thresholds", area.kind.thresholds},
                                  {"area_m2", area.area_m2},
                                  {"zones_m2", std::isnan(area.zones_m2) ? Json() : Json(area.zones_m2)}});
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

Json friction_json(const FrictionByPlace& friction, const std::vector<FrictionArea>& areas) {
    const FrictionChoice& choice = friction.choice();
    const FrictionTable& table = choice.table;
    const auto add_class = [](Json& json, const std::vector<double>& limits, std::size_t at, const std::string& from,
                              const std::string& to) {
        json[from] = at > 0 ? Json(limits[at - 1]) : Json();
        json[to] = at < limits.size() ? Json(limits[at]) : Json();
    };
    Json json{{"name", table.name},
              {"title", table.called},
              {"source", table.named_source},
              {"source_read", table.is_source_read()},
              {"return_period", table.periods[choice.period]},
              {"volume_m3", choice.volume},
              {"friction_factor", choice.friction_factor},
              {"turbulence_factor", choice.turbulence_factor},
              {"curvature_spacing_m", friction.spacing()}};
    add_class(json, table.volumes, choice.volume_class(), "volume_from_m3", "volume_to_m3");
    for (const FrictionArea& area : areas) {
        const FrictionPair pair = choice.at(area.kind, area.band, area.forest);
        Json row{{"terrain", table.terrain[area.kind].name},
                 {"forest", area.forest},
                 {"friction_coefficient", pair.coefficient},
                 {"turbulence", pair.turbulence},
                 {"area_m2", area.area_m2}};
        add_class(row, table.altitudes, area.band, "from_m", "to_m");
        json["areas"].push_back(std::move(row));
    }
    return json;
}

std::int64_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

Json exposure_json(const ExposureTotals& totals) {
    Json json{{"features", totals.features},
              {"reached", totals.reached},
              {"off_map", totals.off_map},
              {"count", totals.count},
              {"count_reached", totals.count_reached},
              {"lower_bound", totals.is_least}};
    for (const DamageSum& one : totals.damages)
        json[one.name] = {{"value", one.damage.value}, {"low", one.damage.low}, {"high", one.damage.high}};
    return json;
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
    if (facts.friction) json["friction_table"] = friction_json(*facts.friction, facts.friction_areas);
    add_run_problems(json, result);
    if (facts.accuracy) json["accuracy"] = accuracy_json(*facts.accuracy);
    json["warnings"] = texts_of(facts.warnings);
    json["warning_values"] = json_of(facts.warnings);
    json[k_data_key] = facts.data_identity;
    return json_text(json);
}

}  // namespace frana::app
