// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_study.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/pictures/map_layer.h"
#include "app/publish/summary.h"
#include "app/store/result_files.h"
#include "app/text/text_table.h"
#include "app/text/version.h"
#include "core/json.h"
#include "core/text.h"

namespace frana::app::study {
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

std::string cell(const std::optional<double>& value) {
    return cell_of(value.value_or(k_no_data));
}

}  // namespace

std::string cell_of(double value) {
    return std::isnan(value) ? "" : shortest_text(value);
}

void add_end(const MemberRecord& member, std::vector<MemberCell>& row) {
    row.push_back({"engine_seconds", shortest_text(member.engine_seconds)});
    const MemberEnd& end = member.end;
    const bool ran = !end.stop_reason.empty();
    const auto number = [&](double value) { return ran ? cell_of(value) : ""; };
    const std::string values[] = {end.stop_reason,           number(end.moving_fraction),
                                  number(end.left_fraction), ran ? std::to_string(static_cast<int>(end.is_held)) : "",
                                  number(end.energy_error),  std::to_string(end.warnings.size())};
    for (std::size_t i = 0; i < std::size(values); ++i) row.push_back({k_end_columns[i], values[i], i > 0});
    row.push_back({"reason", member.failure, false});
}

std::vector<MemberCell> member_row(const StudyInput& input, const StudyResult& result, const MemberRecord& member) {
    std::vector<MemberCell> row;
    const auto text = [&](const std::string& name, const std::string& value) { row.push_back({name, value, false}); };
    const auto number = [&](const std::string& name, const std::string& value) { row.push_back({name, value}); };
    number("member", std::to_string(member.member));
    text("status", member.failure.empty() ? "finished" : "failed");
    number("weight", shortest_text(input.table.weights[member.member]));
    if (result.rates) {
        const auto& all = result.finished_at;
        const auto at = std::lower_bound(all.begin(), all.end(), member.member) - all.begin();
        number("annual_rate",
               member.failure.empty() ? shortest_text(result.rates->of_members()[static_cast<std::size_t>(at)]) : "");
    }
    if (!input.slopes.empty()) {  // what its attributes say
        const Slope& slope = input.slope_of(member.member);
        text("name", slope.name);
        text("group", slope.group);
        text("scenario", slope.scenario);
        number("return_period", cell(slope.return_period));
    }
    const auto& keys = input.table.keys;
    for (std::size_t k = 0; k < keys.size(); ++k) text(keys[k], input.table.values[member.member][k]);
    // A member that was cut ran on: its row repeats it all the same.
    if (std::find(keys.begin(), keys.end(), k_end_key) == keys.end())
        number(k_end_key, member.end.stop_reason.empty() ? "" : shortest_text(member.end.end));
    for (const std::string& figure : figure_columns(result)) number(figure, cell(value_of(member.figures, figure)));
    add_end(member, row);
    return row;
}

std::string csv_of(const std::vector<std::vector<MemberCell>>& rows) {
    std::vector<std::string> heads;
    for (const MemberCell& one : rows.front()) heads.push_back(one.name);
    Table table(heads);
    for (const std::vector<MemberCell>& row : rows) {
        std::vector<Cell> cells;
        for (const MemberCell& one : row) cells.emplace_back(one.text);
        table.row(cells);
    }
    return table.csv();
}

std::string members_csv(const StudyInput& input, const StudyResult& result) {
    std::vector<std::vector<MemberCell>> rows;
    for (const MemberRecord& member : result.members) rows.push_back(member_row(input, result, member));
    return csv_of(rows);
}

std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures) {
    Table table({"figure", "key", "first_order", "total", "rank_correlation", "rank_low", "rank_high", "method", "q2",
                 "effect", "effect_low", "effect_high", "effect_deviation"});
    const auto of = [](const std::optional<Interval>& interval, double Interval::*member) {
        return interval ? cell((*interval).*member) : "";
    };
    for (const FigureSensitivity& figure : figures) {
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const KeySensitivity& one = figure.keys[k];
            table.row({figure.figure.key, input.table.keys[k], cell(one.first_order), cell(one.total),
                       of(one.rank_correlation, &Interval::value), of(one.rank_correlation, &Interval::low),
                       of(one.rank_correlation, &Interval::high), one.method.empty() ? "not measurable" : one.method,
                       cell(figure.q2), of(one.effect, &Interval::value), of(one.effect, &Interval::low),
                       of(one.effect, &Interval::high), one.effect ? cell(one.effect_scatter) : ""});
        }
        if (!std::isnan(figure.q2))
            table.row({figure.figure.key, k_not_explained, shortest_text(std::min(1.0, 1 - figure.q2)), "", "", "", "",
                       "polynomial chaos", cell(figure.q2), "", "", "", ""});
    }
    return table.csv();
}

ShownFriction shown_friction(const StudyInput& input) {
    ShownFriction shown{input.reading.study.region ? k_largest_friction : k_central_friction, {}};
    const bool by_release = !input.base.spec.friction_table.volume.has_value();
    for (const std::string& key : input.table.keys) {
        const std::string section = key.substr(0, key.find('.'));
        if (reads_friction_table(key) || section == "zones" || section == "terrain" ||
            (by_release && (section == "release" || section == "inflow")))
            shown.varied.push_back(key);
    }
    return shown;
}

namespace {

Json figures_json(const StudyResult& result) {
    Json json;
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        Json& figure = json[result.figures()[f].key];
        figure["mean"] = result.mean_of(f).value;
        figure["standard_error_of_mean"] = result.mean_of(f).error;
        const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
        for (const StudyQuantile& quantile : k_study_quantiles) {
            const std::string name = std::string("q") + quantile.name;
            const Interval of_q = result.quantile_of(f, quantile.fraction);
            figure[name] = of_q.value;
            figure["interval_95"][name] = {number(of_q.low), number(of_q.high)};
            if (!result.any_open()) continue;
            // Runs whose full reach is not known may have come farther: null is "more than q".
            figure["upper_bound"][name] = number(result.quantile_bound(f, quantile.fraction));
        }
    }
    return json;
}

Json frequency_json(const FrequencySpec& frequency, const AnnualRates& rates, const StudyFacts& facts) {
    Json json{{"rate_per_year", rates.of_all().value}, {"standard_deviation", rates.of_all().deviation}};
    if (rates.sources().size() > 1) json["sources"] = rates.sources().size();
    if (frequency.volumes)
        for (const FrequencySpec::Volume& one : *frequency.volumes)
            json["volumes"].push_back({{"volume_m3", one.volume}, {"return_period_years", one.years}});
    json["return_periods_years"] = frequency.mapped_periods();
    if (!facts.once_m2.empty()) {
        json["depth_threshold_m"] = facts.reached_threshold;
        for (const Interval& area : facts.once_m2) {
            json["area_exceeded_once_m2"].push_back(area.value);
            json["area_exceeded_once_95_m2"].push_back({area.low, std::isnan(area.high) ? Json() : Json(area.high)});
        }
    }
    json["conditional_on"] = k_condition_with_rate;
    return json;
}

}  // namespace

Json summary_head(const StudyInput& input, const StudyFacts& facts) {
    constexpr const char* k_kinds[] = {"ensemble", "region", "calibration"};
    const StudySpec& study = input.spec();
    const double an_hour = facts.wall_seconds > 0 ? 3600 * static_cast<double>(facts.computed) / facts.wall_seconds : 0;
    return {{"program", k_program},
            {"version", k_version},
            {"format", k_result_format},
            {"date", facts.date},
            {"kind", k_kinds[static_cast<std::size_t>(study.kind)]},
            {"study", study.file},
            {"sampling", name_of(study.sampling)},
            {"seed", study.seed},
            {"run_troubles", json_of(facts.troubles)},
            {"wall_seconds", facts.wall_seconds},
            {"threads", facts.threads},
            {study.is_calibration() ? "runs_per_hour" : "members_per_hour", an_hour},
            {"warnings", texts_of(facts.warnings)},
            {"warning_values", json_of(facts.warnings)}};
}

std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts) {
    const StudySpec& study = input.reading.study;
    const GridSpec& grid = result.grid;
    Json json = summary_head(input, facts);
    json["language"] = input.base.spec.output.language;
    json["scene"] = study.scene;
    json["samples"] = result.members.size();
    json["finished"] = result.finished_at.size();
    json["failed"] = result.failed();
    json["crs"] = input.base.ground.crs_label;
    Json& varied = json["varied"] = Json::array();
    for (const Variation& one : study.vary)
        varied.push_back({{"key", one.key}, {"distribution", one.distribution.text}});
    if (study.vary.empty() && !study.region)
        for (const std::string& key : input.table.keys) varied.push_back({{"key", key}, {"distribution", "table"}});
    json["effective_members"] = result.finished.effective_size();
    if (!study.region) {
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
    json["momentum_flux_thresholds_m3s2"] = input.base.spec.output.momentum_flux_thresholds;
    if (result.rates) json["frequency"] = frequency_json(study.frequency, *result.rates, facts);
    if (const auto& scheme = input.base.spec.hazard.scheme) json["hazard_scheme"] = *scheme;
    if (input.base.friction) {
        const ShownFriction shown = shown_friction(input);
        Json& table = json["friction_table"] = friction_json(*input.base.friction, facts.friction_areas);
        table["of"] = shown.of;
        table["varied_by"] = shown.varied;
    }
    if (!result.figures().empty()) json["figures"] = figures_json(result);
    if (const auto& rare = facts.rare_place)
        json["rare_place"] = {{"gauge", rare->event.gauge},
                              {"depth_threshold_m", rare->event.threshold},
                              {"probability", rare->probability.value},
                              {"standard_error", rare->probability.error},
                              {"interval_95", {rare->probability.low(), rare->high}},
                              {"members_that_came", rare->hits}};
    json["scheme"] = scheme_json(input);
    if (facts.scheme_check) json["scheme_check"] = check_json(*facts.scheme_check);
    Json& failures = json["failures"] = Json::array();
    for (const MemberRecord& member : result.members)
        if (!member.failure.empty()) failures.push_back({{"member", member.member}, {"reason", member.failure}});
    if (facts.exposure) json["exposure"] = exposure_json(*facts.exposure);
    return json_text(json);
}

}  // namespace frana::app::study
