// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/study_tables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/pictures/animation.h"
#include "app/pictures/map_layer.h"
#include "app/pictures/result_reader.h"
#include "app/process/terminal.h"
#include "app/publish/summary.h"
#include "app/store/frame_store.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/study/publish/study_files.h"
#include "app/text/number_text.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/json.h"
#include "core/text.h"
#include "params/keys/scene_parameters.h"
#include "simulation/simulation.h"

namespace frana::app::study {
namespace {

void write_frames(const StudyInput& input, const StudyResult& result, std::size_t member,
                  const ResultDirectory& directory) {
    RunLog silent(true);
    Prepared prepared = prepare(input.member(member), silent);
    prepared.scene.time.end = result.members[member].end.end;
    if (!prepared.scene.grid.same_cells(result.grid))
        throw Error(ErrorKind::input,
                    Problem{"has other cells than the maps", "member " + std::to_string(member), "", "",
                            "`frana run` with its values from " + std::string(k_member_table) + " makes the film"});
    directory.make_folder(k_frame_folder);
    FrameWriter frames(directory.path(k_frame_folder), provenance(prepared));
    RunOptions options;
    options.on_frame = [&](Frame frame) { frames.add(std::move(frame)); };
    options.stop_requested = [&] { return stop_signal() != 0 || frames.failed(); };
    run(prepared.scene, options);
    frames.finish();
}

void remove_frames(const ResultDirectory& directory) {
    std::error_code ignored;  // what is left belongs to the files of a result
    std::filesystem::remove_all(directory.path(k_frame_folder), ignored);
}

std::string sentence(const MedianMember& median) {
    return "member " + std::to_string(median.member) + ", " + median.figure.title + " " + grouped(median.figure.value) +
           " " + median.figure.unit + " (median of all " + grouped(median.median) + ")";
}

}  // namespace

std::optional<MedianMember> median_member(const StudyResult& result) {
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        if (result.figures()[f].key != k_median_figure) continue;
        const std::vector<double> values = result.figure(f);
        const double median = weighted_quantile(values, result.finished.weights, 0.5);
        std::optional<std::size_t> nearest;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!nearest || std::abs(values[i] - median) < std::abs(values[*nearest] - median)) nearest = i;
        }
        if (!nearest) return std::nullopt;
        const MemberResult& member = result.members[result.finished_at[*nearest]];
        return MedianMember{member.member, member.figures[f], median};
    }
    return std::nullopt;
}

void film_member(const StudyInput& input, const StudyResult& result, const MedianMember& median,
                 const ResultDirectory& directory, RunLog& log) {
    const OutputSpec& output = input.base.spec.output;
    if (!output.animation) return;
    try {
        write_frames(input, result, median.member, directory);
        const ResultReader written(directory.folder());
        MapSource source = written.map_source();
        source.title = output.title.value_or(scene_name(input.base.spec));
        const Words& words = source.style.words;
        source.subtitle = words("member {1}, {2} {3} {4} (median of all {5})",
                                {std::to_string(median.member), figure_title(median.figure, words),
                                 words.number(grouped(median.figure.value)), unit_sign(median.figure.unit),
                                 words.number(grouped(median.median))});
        AnimationRequest film{
            animation_source(written, source, "depth"), {}, false, false, animation_size(source.style.size)};
        film.stop_requested = [] { return stop_signal() != 0; };
        if (stop_signal() == 0 && write_animation(film, directory.path(k_animation_file)))
            log.note(std::string("drew ") + k_animation_file + ": " + sentence(median));
        else
            log.warn(worded("{1} is left out because of the signal", {k_animation_file}));
    } catch (const std::exception& error) {
        log.warn(worded("{1} could not be drawn: {2}", {k_animation_file, std::string(error.what())}));
    }
    remove_frames(directory);
}

namespace {

/// Columns that scripts read, before the figures of gauges and others.
constexpr const char* k_first_figures[] = {"runout_m", "covered_area_m2", "max_depth_m", "max_velocity_ms",
                                           "volume_m3"};

std::vector<std::string> figure_columns(const StudyResult& result) {
    std::vector<std::string> columns(std::begin(k_first_figures), std::end(k_first_figures));
    for (const Figure& figure : result.figures())
        if (std::find(columns.begin(), columns.end(), figure.key) == columns.end()) columns.push_back(figure.key);
    return columns;
}

std::string figure_cell(const MemberResult& member, const std::string& key) {
    for (const Figure& figure : member.figures)
        if (figure.key == key) return shortest_text(figure.value);
    return "";
}

std::string cells(const std::optional<Interval>& interval) {
    if (!interval || std::isnan(interval->low)) return ",";
    return shortest_text(interval->low) + "," + shortest_text(interval->high);
}

std::string value_cell(const std::optional<Interval>& interval) {
    return interval ? shortest_text(interval->value) : "";
}

/// What the attributes of a region's slopes say, and the terrain on which each ran, as terrain.bounds takes it.
std::string slope_columns(const StudyInput& input) {
    return input.slopes.empty() ? "" : ",name,group,scenario,return_period,terrain.bounds";
}

std::string slope_cells(const StudyInput& input, const MemberResult& member) {
    if (input.slopes.empty()) return "";
    const Slope& slope = input.slopes[member.member];
    const Bounds& box = member.terrain;
    const std::string bounds = shortest_text(box.west) + " " + shortest_text(box.south) + " " +
                               shortest_text(box.east) + " " + shortest_text(box.north);
    return "," + csv_cell(slope.name) + "," + csv_cell(slope.group) + "," + csv_cell(slope.scenario) + "," +
           (slope.return_period ? shortest_text(*slope.return_period) : "") + "," +
           (member.figures.empty() ? "" : bounds);
}

}  // namespace

std::string members_csv(const StudyInput& input, const StudyResult& result) {
    const std::vector<std::string> figures = figure_columns(result);
    std::string text = "member,status,weight";
    text += slope_columns(input);
    for (const std::string& key : input.table.keys) text += "," + csv_cell(key);
    // A member that was cut ran on: its row repeats it all the same.
    const auto& keys = input.table.keys;
    const bool has_end = std::find(keys.begin(), keys.end(), k_end_key) == keys.end();
    if (has_end) text += std::string(",") + k_end_key;
    for (const std::string& figure : figures) text += "," + csv_cell(figure);
    text += ",engine_seconds";
    for (const char* column : k_end_columns) text += std::string(",") + column;
    text += ",reason\n";
    for (const MemberResult& member : result.members) {
        text += std::to_string(member.member) + (member.failure.empty() ? ",finished," : ",failed,") +
                shortest_text(input.table.weights[member.member]);
        text += slope_cells(input, member);
        for (const std::string& value : input.table.values[member.member]) text += "," + csv_cell(value);
        if (has_end) text += "," + (member.end.stop_reason.empty() ? "" : shortest_text(member.end.end));
        for (const std::string& figure : figures) text += "," + figure_cell(member, figure);
        text += "," + shortest_text(member.engine_seconds);
        for (const std::string& cell : end_values(member.end)) text += "," + csv_cell(cell);
        text += "," + csv_cell(member.failure) + "\n";
    }
    return text;
}

std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures) {
    std::string text =
        "figure,key,first_order,total,low,high,total_low,total_high,rank_correlation,rank_low,rank_high,method,q2,"
        "effect,effect_low,effect_high,effect_deviation\n";
    for (const FigureSensitivity& figure : figures) {
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const KeySensitivity& one = figure.keys[k];
            text += csv_cell(figure.figure.key) + "," + csv_cell(input.table.keys[k]) + "," +
                    value_cell(one.first_order) + "," + value_cell(one.total) + "," + cells(one.first_order) + "," +
                    cells(one.total) + "," + value_cell(one.rank_correlation) + "," + cells(one.rank_correlation) +
                    "," + (one.method.empty() ? "not measurable" : one.method) + "," +
                    (std::isnan(figure.q2) ? "" : shortest_text(figure.q2)) + "," + value_cell(one.effect) + "," +
                    cells(one.effect) + "," + (one.effect ? shortest_text(one.effect_scatter) : "") + "\n";
        }
        // A field of error is in what the polynomials of the keys do not explain.
        const bool has_field = std::any_of(figure.keys.begin(), figure.keys.end(),
                                           [](const KeySensitivity& one) { return one.method == k_not_explained; });
        if (has_field)
            text += csv_cell(figure.figure.key) + "," + k_not_explained + "," + shortest_text(1 - figure.q2) +
                    ",,,,,,,,,polynomial chaos," + shortest_text(figure.q2) + ",,,,\n";
    }
    return text;
}

ShownFriction shown_friction(const StudyInput& input) {
    ShownFriction shown{input.reading.study.per_polygon() ? k_largest_friction : k_central_friction, {}};
    const bool by_release = !input.base.spec.friction_table.volume.has_value();
    for (const std::string& key : input.table.keys) {
        const std::string section = key.substr(0, key.find('.'));
        if (reads_friction_table(key) || section == "zones" || section == "terrain" ||
            (by_release && (section == "release" || section == "inflow")))
            shown.varied.push_back(key);
    }
    return shown;
}

std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts) {
    const StudySpec& study = input.reading.study;
    const GridSpec& grid = result.grid;
    Json json{{"program", k_program},
              {"version", k_version},
              {"format", k_result_format},
              {"date", facts.date},
              {"kind", study.region ? "region" : "ensemble"},
              {"language", input.base.spec.output.language},
              {"study", study.file},
              {"scene", study.scene},
              {"sampling", name_of(study.sampling)},
              {"seed", study.seed},
              {"samples", result.members.size()},
              {"finished", result.finished_at.size()},
              {"failed", result.failed()},
              {"run_troubles", json_of(facts.troubles)},
              {"wall_seconds", facts.wall_seconds},
              {"threads", facts.threads},
              {"members_per_hour",
               facts.wall_seconds > 0 ? 3600 * static_cast<double>(facts.computed) / facts.wall_seconds : 0},
              {"crs", input.base.ground.crs_label}};
    Json& varied = json["varied"] = Json::array();
    for (const Variation& one : study.vary)
        varied.push_back({{"key", one.key}, {"distribution", one.distribution.text}});
    if (study.vary.empty() && !study.per_polygon())
        for (const std::string& key : input.table.keys) varied.push_back({{"key", key}, {"distribution", "table"}});
    json["effective_members"] = result.finished.effective_size();
    if (!study.per_polygon()) {
        json["largest_standard_error"] = facts.error.largest();
        json["mean_standard_error"] = facts.error.mean();
        json["margin_at_0_and_1"] = facts.least_margin;
    }
    if (study.until)
        json["until"] = {{"standard_error", *study.until}, {"reached", facts.error.largest() <= *study.until}};
    json["grid"] = {{"columns", grid.columns},
                    {"rows", grid.rows},
                    {"cell_size", grid.cell_size},
                    {"west", grid.west},
                    {"north", grid.north}};
    json["depth_thresholds_m"] = input.base.spec.output.depth_thresholds;
    json["velocity_thresholds_ms"] = input.base.spec.output.velocity_thresholds;
    json["pressure_thresholds_kpa"] = input.base.spec.output.pressure_thresholds;
    if (const auto& scheme = input.base.spec.hazard.scheme) json["hazard_scheme"] = *scheme;
    if (input.base.friction) {
        const ShownFriction shown = shown_friction(input);
        Json& table = json["friction_table"] = friction_json(*input.base.friction, facts.friction_areas);
        table["of"] = shown.of;
        table["varied_by"] = shown.varied;
    }
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        Json& figure = json["figures"][result.figures()[f].key];
        figure["mean"] = result.mean_of(f).value;
        figure["standard_error_of_mean"] = result.mean_of(f).error;
        const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
        for (const StudyQuantile& quantile : k_study_quantiles) {
            const std::string name = std::string("q") + quantile.name;
            const Interval of_q = result.quantile_of(f, quantile.fraction);
            figure[name] = of_q.value;
            figure["interval_95"][name] = {number(of_q.low), number(of_q.high)};
            if (!result.open.any()) continue;
            // Runs whose full reach is not known may have come farther: null is "more than q".
            figure["upper_bound"][name] = number(result.quantile_bound(f, quantile.fraction));
        }
    }
    if (const auto& rare = facts.rare_place)
        json["rare_place"] = {{"gauge", rare->event.gauge},
                              {"depth_threshold_m", rare->event.threshold},
                              {"probability", rare->probability.value},
                              {"standard_error", rare->probability.error},
                              {"interval_95", {rare->probability.low(), rare->high}},
                              {"members_that_came", rare->hits}};
    json["scheme"] = scheme_json(input);
    if (facts.scheme_check) json["scheme_check"] = check_json(*facts.scheme_check);
    if (const auto& median = facts.median)
        json["median_member"] = {{"member", median->member},
                                 {"figure", median->figure.key},
                                 {"value", median->figure.value},
                                 {"median", median->median}};
    Json& failures = json["failures"] = Json::array();
    for (const MemberResult& member : result.members)
        if (!member.failure.empty()) failures.push_back({{"member", member.member}, {"reason", member.failure}});
    if (facts.exposure) json["exposure"] = exposure_json(*facts.exposure);
    json["warnings"] = texts_of(facts.warnings);
    json["warning_values"] = json_of(facts.warnings);
    return json_text(json);
}

}  // namespace frana::app::study
