// SPDX-License-Identifier: Apache-2.0
#include "app/store/accuracy_record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/text/number_text.h"
#include "core/error.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

constexpr const char* k_caution = "Discretisation only: errors of data, material and model are not included";

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

std::string error_text(const ValueEstimate& estimate) {
    if (!std::isfinite(estimate.percent())) return number_text(estimate.error, 2) + " " + estimate.value.unit;
    return number_text(estimate.percent(), 2) + " %";
}

/// States the cell size of the result and of its terrain.
std::string cells_sentence(const AccuracyRecord& record) {
    std::string text = "the result is on cells of " + cells(record.chosen_cell_size);
    if (record.is_finest()) text += ", the scene's own";
    if (record.terrain_cell_size > 0 && record.chosen_cell_size < record.terrain_cell_size * (1 - 1e-9))
        text += ", finer than the DTM's " + cells(record.terrain_cell_size) +
                ": between its cells the terrain is interpolated";
    return text;
}

/// "all 6 values", and the number of values without an estimate.
std::string claimed_values(const std::vector<ValueEstimate>& estimates) {
    const auto zeros =
        std::count_if(estimates.begin(), estimates.end(), [](const ValueEstimate& e) { return e.is_zero; });
    const std::string all = "all " + std::to_string(static_cast<std::ptrdiff_t>(estimates.size()) - zeros) + " values";
    return zeros == 0
               ? all
               : all + " that are not zero on all levels; " + std::to_string(zeros) + " are, without an estimate";
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
    std::vector<ValueEstimate> estimates;
    for (std::size_t i = 0; i < last.values.size(); ++i) {
        std::vector<Refinement> refinements;
        for (const AccuracyLevel* level : levels) refinements.push_back({level->cell_size, level->values.at(i).value});
        ValueEstimate estimate;
        estimate.value = last.values[i];
        estimate.is_zero = std::all_of(refinements.begin(), refinements.end(),
                                       [](const Refinement& level) { return level.value == 0; });
        estimate.convergence = grid_convergence(refinements, detail);
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
            values.push_back({v.key, v.title, v.unit, v.value, v.resolution, v.negligible});
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
        for (const Json& v : row.at(6)) level.values.push_back({v.at(0), v.at(1), v.at(2), v.at(3), v.at(4), v.at(5)});
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
              {"verdict", accuracy_verdict(record)},
              {"cell_size_m", record.chosen_cell_size},
              {"finest_cell_size_m", record.finest_cell_size},
              {"dtm_cell_size_m", record.terrain_cell_size},
              {"levels", Json::array()},
              {"values", Json::array()}};
    for (const AccuracyLevel& level : record.levels) json["levels"].push_back(level_json(level));
    for (const ValueEstimate& e : estimates) {
        json["values"].push_back({{"key", e.value.key},
                                  {"title", e.value.title},
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
            text += grouped(level.particles) + " particles, " + grouped(level.steps) + " steps, " +
                    number_text(level.wall_seconds, 3) + " s\n";
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
            text += "  " + e.value.title + " 0 " + e.value.unit + " on all levels: no estimate\n";
            continue;
        }
        text += "  " + e.value.title + " " + number_text(e.value.value) + " " + e.value.unit + ", estimated error " +
                number_text(e.error, 2) + " " + e.value.unit;
        if (e.value.value != 0) text += " (" + number_text(e.percent(), 2) + " %)";
        text += std::string("; ") + describe(e.convergence.trend);
        if (e.convergence.trend == Trend::converging) text += ", order " + number_text(e.convergence.observed_order, 2);
        text += e.is_within() ? "\n" : "; not claimed\n";
    }
    if (!text.empty()) text.pop_back();
    return text;
}

std::string accuracy_verdict(const AccuracyRecord& record) {
    const std::vector<ValueEstimate> estimates = value_estimates(record);
    const std::string asked = "numerics.accuracy = " + percent_text(record.asked);
    if (estimates.empty())
        return asked + " is not claimed: there are too few coarser levels for an estimate of error; " +
               cells_sentence(record);
    if (is_reached(estimates))
        return asked + " is met according to the estimate for " + claimed_values(estimates) + "; " +
               cells_sentence(record) + ". " + k_caution;
    constexpr std::size_t k_named = 4;
    std::vector<std::string> named;
    std::size_t unmet = 0;
    for (const ValueEstimate& e : estimates) {
        if (e.is_zero || e.is_within()) continue;
        if (++unmet <= k_named) named.push_back(e.value.title + " (" + error_text(e) + ")");
    }
    if (unmet > k_named) named.push_back("and " + std::to_string(unmet - k_named) + " more");
    std::string text =
        asked + " is not claimed for " + std::to_string(unmet) + " of " + std::to_string(estimates.size()) +
        " values, whose estimated error is greater: " + joined(named, ", ") + "; " + cells_sentence(record);
    if (!record.is_finest())
        text += ". The scene's own cells of " + cells(record.finest_cell_size) +
                " were not computed: the estimate does not expect them to reach it. Run without numerics.accuracy for "
                "them, or ask for less";
    return text + ". " + k_caution;
}

}  // namespace frana::app
