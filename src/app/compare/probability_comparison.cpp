// SPDX-License-Identifier: Apache-2.0
#include "app/compare/probability_comparison.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/trace.h"
#include "app/compare/comparison.h"
#include "app/pictures/result_reader.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/json.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "params/grammar/value_text.h"
#include "render/chart/chart.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_depth = "probability_depth_";

/// The file of a study whose depth threshold is meant.
std::string map_of_study(const ResultReader& result, const std::optional<double>& threshold) {
    std::vector<std::pair<double, std::string>> maps;
    std::vector<std::string> known;
    for (const std::string& name : result.drawable()) {
        if (!name.starts_with(k_depth)) continue;
        const std::string value = name.substr(std::string(k_depth).size());
        if (const auto number = number_from_text(value)) maps.emplace_back(*number, name);
    }
    std::sort(maps.begin(), maps.end());
    for (const auto& [depth, name] : maps) known.push_back(shortest_text(depth));
    const auto find = [&](double depth) -> const std::string* {
        for (const auto& [one, name] : maps)
            if (one == depth) return &name;
        return nullptr;
    };
    if (threshold) {
        if (const std::string* name = find(*threshold)) return *name;
        throw Error(ErrorKind::input,
                    Problem{"has no map of probability", "--threshold", shortest_text(*threshold), joined(known, ", "),
                            "Choose one of these, or add it to output.depth-thresholds of the scene"});
    }
    if (maps.empty())
        throw Error(ErrorKind::input, Problem{"has no map of the probability of a depth", "RESULT_DIR",
                                              result.directory(), "", "Set output.depth-thresholds in the scene"});
    const double usual = result.scene_number("observed.threshold", maps.front().first);
    const std::string* const name = find(usual);
    return name != nullptr ? *name : maps.front().second;
}

render::ChartPanel reliability_panel(const ProbabilityScores& scores, const Words& words) {
    render::ChartPanel panel{words("Reliability"), words("Probability"), words("Observed fraction of the cells"), {}};
    panel.on_x = panel.on_y = {0, 1};
    render::ChartSeries classes{words("Map"), render::k_chart_colours[0], {}};
    classes.marker = render::Marker::circle;
    for (const ReliabilityClass& one : scores.classes)
        if (one.area_m2 > 0) classes.points.push_back({one.mean_probability, one.observed_fraction});
    render::ChartSeries ideal{words("perfect"), {90, 90, 90}, {{0, 0}, {1, 1}}, 1.6, render::Stroke::dashed};
    panel.series = {classes, ideal};
    return panel;
}

render::ChartPanel roc_panel(const ProbabilityScores& scores, const Words& words) {
    render::ChartPanel panel{
        words.labelled(words("Area under the ROC curve"), words.number(number_text(scores.auroc, 3))),
        words("False positive rate"),
        words("True positive rate"),
        {}};
    panel.on_x = panel.on_y = {0, 1};
    render::ChartSeries curve{words("Map"), render::k_chart_colours[0], {{0, 0}}};
    for (const RocPoint& point : scores.roc)
        curve.points.push_back({point.false_positive_rate, point.true_positive_rate});
    curve.points.push_back({1, 1});
    render::ChartSeries chance{words("no skill"), {90, 90, 90}, {{0, 0}, {1, 1}}, 1.6, render::Stroke::dashed};
    panel.series = {curve, chance};
    return panel;
}

std::string roc_csv(const ProbabilityScores& scores) {
    std::string text = "probability,true_positive_rate,false_positive_rate\n";
    for (const RocPoint& point : scores.roc)
        text += shortest_text(point.value) + "," + shortest_text(point.true_positive_rate) + "," +
                shortest_text(point.false_positive_rate) + "\n";
    return text;
}

std::string reliability_csv(const ProbabilityScores& scores) {
    std::string text = "from,to,area_m2,mean_probability,observed_fraction\n";
    for (const ReliabilityClass& one : scores.classes) {
        const bool any = one.area_m2 > 0;
        text += shortest_text(one.least) + "," + shortest_text(one.most) + "," + shortest_text(one.area_m2) + "," +
                (any ? shortest_text(one.mean_probability) : "") + "," +
                (any ? shortest_text(one.observed_fraction) : "") + "\n";
    }
    return text;
}

}  // namespace

bool is_probability(const std::string& operand) {
    if (fs::is_directory(operand)) return ResultReader(operand).is_of_study();
    if (!fs::is_regular_file(operand)) return false;
    // One that cannot be read is read again, and refused with its name.
    return attempt([&] { return probability_name(operand).has_value(); });
}

ProbabilityMap read_probability_map(const std::string& operand, const std::optional<double>& threshold) {
    ProbabilityMap map;
    if (fs::is_directory(operand)) {
        const ResultReader result(operand);
        map.name = map_of_study(result, threshold);
        map.file = result.path(raster_file(map.name));
        map.values = result.raster(map.name);
        map.source = result.map_source();
        return map;
    }
    if (threshold)
        throw Error(ErrorKind::input, Problem{"has no effect on one map of probability", "--threshold",
                                              shortest_text(*threshold), "", "Name the result directory instead"});
    map.name = *probability_name(operand);
    map.file = operand;
    map.values = gis::read_result_raster(operand);
    map.source.title = fs::path(operand).stem().string();
    map.source.crs_label = gis::crs_name(map.values.grid.crs_wkt);
    map.source.style.words = Words(process_language());
    return map;
}

ProbabilityScores compare_with_survey(const ProbabilityMap& map, const Survey& survey, RunLog& log) {
    if (survey.scar.empty())
        throw Error(ErrorKind::input, Problem{"is no area, and probabilities are compared with areas", "--observed",
                                              survey.front_label, "polygons or closed lines", ""});
    if (!survey.fronts.empty() || !survey.tips.empty())
        log.warn(worded("fronts and tips are not compared with a map of probability"));
    const Raster values = padded_to(map.values, bounds(survey.scar), k_no_data);
    if (!values.grid.same_cells(map.values.grid))
        log.warn(worded("survey beyond the rasters: its part outside counts as missed"));
    return score_probability(values, gis::coverage(survey.scar, values.grid));
}

std::string probability_json(const ProbabilityScores& scores, const ProbabilityMap& map, const Survey& survey) {
    const Json json{{"program", k_program},
                    {"version", k_version},
                    {"kind", "probability"},
                    {"simulated", map.file},
                    {"map", map.name},
                    {"observed", survey.scar_label},
                    {"cell_size", map.values.grid.cell_size},
                    {"observed_area_m2", scores.observed_area_m2},
                    {"compared_area_m2", scores.compared_area_m2},
                    {"brier", scores.brier},
                    {"brier_reliability", scores.reliability},
                    {"brier_resolution", scores.resolution},
                    {"brier_uncertainty", scores.uncertainty},
                    {"brier_within_classes", scores.within_classes},
                    {"brier_skill", scores.brier_skill},
                    {"auroc", scores.auroc},
                    {"negatives", "cells that were not observed are five times the observed area"}};
    return json_text(json);
}

render::Chart probability_chart(const ProbabilityScores& scores, const ProbabilityMap& map) {
    const Words& words = map.source.style.words;
    return {page_title(map.source, words("Comparison with the survey")),
            map.name + "; Brier " + words.number(number_text(scores.brier, 3)) + "; " +
                words.labelled(words("Brier skill"), words.number(number_text(scores.brier_skill, 3))),
            std::string(k_comparison_file),
            2,
            {reliability_panel(scores, words), roc_panel(scores, words)},
            false,
            words};
}

void write_probability_comparison(const ProbabilityScores& scores, const ProbabilityMap& map, const Survey& survey,
                                  const std::string& folder) {
    const auto path = [&](const char* name) { return (fs::path(folder) / name).string(); };
    write_text_file(path(k_comparison_file), probability_json(scores, map, survey));
    write_text_file(path(k_roc_table), roc_csv(scores));
    write_text_file(path(k_reliability_table), reliability_csv(scores));
    const render::Chart chart = probability_chart(scores, map);
    const Size size = map.source.style.size;
    write_plain_picture(render::chart_page(chart, size.width, size.height), map.source.style, chart.title,
                        comparison_stem(folder));
}

}  // namespace frana::app
