// SPDX-License-Identifier: Apache-2.0
#include "app/store/accuracy_record.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/store/json_file.h"
#include "app/store/result_files.h"
#include "app/store/series_ends.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "params/grammar/value_text.h"
#include "params/scene/write_scene.h"

namespace frana::app {
namespace {

// FNV-1a, 64 bits.
std::uint64_t hash(const std::string& text) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return h;
}

// Returns a scene's text without its comments, which state the source of each value.
std::string values_only(const std::string& text) {
    std::istringstream lines(text);
    std::string line, values;
    while (std::getline(lines, line)) {
        if (!line.empty() && line.front() != '#') values += line.substr(0, line.find(" #")) + '\n';
    }
    return values;
}

}  // namespace

std::string numbers_fingerprint(const SceneSpec& scene) {
    SceneSpec numbers = scene;
    numbers.output = OutputSpec{};
    numbers.observed = ObservedSpec{};
    numbers.time.frame_interval = TimeSpec{}.frame_interval;
    char text[32];
    std::snprintf(text, sizeof text, "%016llx",
                  static_cast<unsigned long long>(hash(values_only(scene_text(numbers, {})))));
    return text;
}

std::string convergence_directory(const std::string& result_directory) {
    return result_directory + "-convergence";
}

void write_error_estimate(const std::string& folder, const SceneSpec& scene, const std::string& sentences) {
    write_text_file((std::filesystem::path(folder) / k_error_estimate_file).string(),
                    numbers_fingerprint(scene) + '\n' + sentences);
}

std::optional<std::string> read_error_estimate(const std::string& result_directory, const SceneSpec& scene) {
    std::ifstream file(std::filesystem::path(convergence_directory(result_directory)) / k_error_estimate_file);
    std::string fingerprint;
    if (!std::getline(file, fingerprint) || fingerprint != numbers_fingerprint(scene)) return std::nullopt;
    std::ostringstream rest;
    rest << file.rdbuf();
    return rest.str();
}

std::optional<MainStatistics> read_main_statistics(const std::string& result_folder) {
    const std::string path = (std::filesystem::path(result_folder) / k_summary_file).string();
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::optional<Json> summary = read_json_file(path);
    if (!summary)
        throw Error(ErrorKind::input, Problem{"is incomplete", path, "", "", "Restore it, or compute the scene again"});
    MainStatistics statistics;
    const auto read = [&](const std::string& name, double& value) {
        const std::optional<double> number = value_in<double>(*summary, name);
        value = number.value_or(0);
        return number.has_value();
    };
    const auto read_runout = [&](const std::string& place) {
        Runout& one = statistics.run_outs.emplace_back();
        return read(place + "/horizontal_m", one.horizontal_m) && read(place + "/drop_m", one.drop_m) &&
               read(place + "/reach_angle_deg", one.reach_angle_deg);
    };
    if (!read("/trace_threshold_m", statistics.threshold) || !read("/covered_area_m2", statistics.covered_area_m2) ||
        !read_runout("/runout"))
        return std::nullopt;
    // The first of the flows is the one in "runout". Results of older programs do not list them.
    for (std::size_t i = 0; summary->contains(Json::json_pointer("/flows/" + std::to_string(i))); ++i) {
        const std::string flow = "/flows/" + std::to_string(i);
        if (i > 0 && !read_runout(flow)) return std::nullopt;
        Runout& one = statistics.run_outs.back();
        read(flow + "/covered_area_m2", one.covered_area_m2);
        for (const auto& [name, point] : {std::pair{"/top", &one.top}, std::pair{"/tip", &one.tip}}) {
            read(flow + name + "_x", point->x);
            read(flow + name + "_y", point->y);
        }
    }
    const auto reason = value_in<std::string>(*summary, "/stop_reason_text");
    const std::string series = (std::filesystem::path(result_folder) / k_series_file).string();
    if (reason && std::filesystem::exists(series)) {
        const SeriesEnds ends = read_series_ends(series);
        statistics.end = run_end(*reason, ends.simulated_seconds, ends.last_speed,
                                 value_in<double>(*summary, "/moving_fraction").value_or(0),
                                 value_in<bool>(*summary, "/settling/front_is_final").value_or(false));
        statistics.end->is_held = value_in<bool>(*summary, "/held_by_no_data").value_or(false);
    }
    return statistics;
}

std::vector<Point> flow_tops(const std::optional<MainStatistics>& statistics) {
    std::vector<Point> tops;
    if (!statistics) return tops;
    for (const Runout& one : statistics->run_outs)
        if (one.covered_area_m2 > 0) tops.push_back(one.top);
    return tops;
}

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
std::string error_text(const ValueEstimate& estimate, const Words& words) {
    const bool has_percent = std::isfinite(estimate.percent());
    return words.number(number_text(has_percent ? estimate.percent() : estimate.error, 2)) + " " +
           (has_percent ? "%" : estimate.value.unit);
}

/// States the cell size of the result and of its terrain.
std::string cells_sentence(const AccuracyRecord& record, const Words& words) {
    const std::string size = words.number(number_text(record.chosen_cell_size));
    std::string text = record.is_finest() ? words("the result is on cells of {1} m, the scene's own", {size})
                                          : words("the result is on cells of {1} m", {size});
    if (record.terrain_cell_size > 0 && record.chosen_cell_size < record.terrain_cell_size * (1 - 1e-9))
        text += ", " + words("finer than the DTM's {1} m: between its cells the terrain is interpolated",
                             {words.number(number_text(record.terrain_cell_size))});
    return text;
}

/// "all 6 values", and the number of values without an estimate.
std::string claimed_values(const std::vector<ValueEstimate>& estimates, const Words& words) {
    const auto zeros =
        std::count_if(estimates.begin(), estimates.end(), [](const ValueEstimate& e) { return e.is_zero; });
    const std::string all = std::to_string(static_cast<std::ptrdiff_t>(estimates.size()) - zeros);
    return zeros == 0 ? words("all {1} values", {all})
                      : words("all {1} values that are not zero on all levels; {2} are, without an estimate",
                              {all, std::to_string(zeros)});
}

std::string caution(const Words& words) {
    return words("Discretisation only: errors of data, material and model are not included");
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

std::string accuracy_verdict(const AccuracyRecord& record, const Words& words) {
    const std::vector<ValueEstimate> estimates = value_estimates(record);
    const std::string asked = "numerics.accuracy = " + words.number(percent_text(record.asked));
    const std::string result = cells_sentence(record, words);
    if (estimates.empty())
        return words("{1} is not claimed: there are too few coarser levels for an estimate of error; {2}",
                     {asked, result});
    if (is_reached(estimates))
        return words("{1} is met according to the estimate for {2}; {3}",
                     {asked, claimed_values(estimates, words), result}) +
               ". " + caution(words);
    constexpr std::size_t k_named = 4;
    std::vector<std::string> named;
    std::size_t unmet = 0;
    for (const ValueEstimate& e : estimates) {
        if (e.is_zero || e.is_within()) continue;
        if (++unmet <= k_named) named.push_back(title_in(e.value, words) + " (" + error_text(e, words) + ")");
    }
    if (unmet > k_named) named.push_back(words("and {1} more", {std::to_string(unmet - k_named)}));
    std::string text =
        words("{1} is not claimed for {2} of {3} values, whose estimated error is greater: {4}; {5}",
              {asked, std::to_string(unmet), std::to_string(estimates.size()), joined(named, ", "), result});
    if (!record.is_finest())
        text += ". " + words(
                           "The scene's own cells of {1} m were not computed: the estimate does not expect them to "
                           "reach it. Run without numerics.accuracy for them, or ask for less",
                           {words.number(number_text(record.finest_cell_size))});
    return text + ". " + caution(words);
}

}  // namespace frana::app
