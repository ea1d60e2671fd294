// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_report.h"

#include <filesystem>

#include "app/ensemble/region_report.h"
#include "app/ensemble/study_exposure.h"
#include "app/input/scene_language.h"
#include "app/publish/html_page.h"
#include "app/publish/html_table.h"
#include "app/publish/report_exposure.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/markup.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string keys_table(const StudyInput& input) {
    HtmlTable table({"key", "distribution"});
    for (const study::Variation& one : input.reading.study.vary) table.row({one.key, one.distribution.text});
    for (const study::Correlation& one : input.reading.study.correlate)
        table.row({one.first + " and " + one.second, "rank correlation " + number_text(one.rho)});
    return table.html();
}

std::string figures_table(const StudyResult& result) {
    HtmlTable table({"figure", "unit", "mean", "5 %", "50 %", "95 %"});
    const std::vector<double>& weights = result.finished.weights;
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        const std::vector<double> values = result.figure(f);
        table.row({result.figures()[f].title, result.figures()[f].unit, number_text(weighted_mean(values, weights)),
                   number_text(figure_quantile(values, weights, 0.05)),
                   number_text(figure_quantile(values, weights, 0.5)),
                   number_text(figure_quantile(values, weights, 0.95))});
    }
    return table.html();
}

std::string levels_table(const std::vector<LevelSummary>& levels) {
    double all = 0;
    for (const LevelSummary& level : levels) all += level.statistics.cost * static_cast<double>(level.members);
    HtmlTable table({"level", "cells", "members", "variance of the difference", "part of the cost"});
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const LevelSummary& level = levels[l];
        const double cost = level.statistics.cost * static_cast<double>(level.members);
        table.row({std::to_string(l), number_text(level.cell_size) + " m", std::to_string(level.members),
                   number_text(100 * level.statistics.variance / levels.front().statistics.variance, 2) +
                       " % of that on level 0",
                   number_text(100 * cost / all, 2) + " %"});
    }
    return table.html();
}

std::string interval_text(const std::optional<study::Interval>& one) {
    if (!one) return "";
    return number_text(one->value, 2) + " (" + number_text(one->low, 2) + " to " + number_text(one->high, 2) + ")";
}

std::string sensitivity_table(const StudyInput& input, const std::vector<FigureSensitivity>& figures) {
    HtmlTable table({"figure", "key", "first order", "total", "rank correlation", "method"});
    for (const FigureSensitivity& figure : figures)
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const study::KeySensitivity& one = figure.keys[k];
            table.row({figure.figure.title, input.table.keys[k], interval_text(one.first_order),
                       interval_text(one.total), interval_text(one.rank_correlation),
                       one.method.empty() ? "not measurable" : one.method});
        }
    return table.html();
}

std::string median_paragraph(const StudyInput& input, const MedianMember& median, const ResultDirectory& directory) {
    std::string values;
    for (const std::string& one : input.table.overrides(median.member)) values += (values.empty() ? "" : ", ") + one;
    const bool has_film = fs::exists(directory.path(k_animation_file));
    return "<h2 id=\"median\">Median member</h2>\n<p>Member " + std::to_string(median.member) + ": " +
           escaped_markup(median.figure.title) + " " + number_text(median.figure.value) + " " +
           escaped_markup(median.figure.unit) + ", nearest to the weighted median of all, " +
           number_text(median.median) + ". Its values: " + escaped_markup(values) + "." +
           (has_film ? std::string(" <a href=\"") + k_animation_file + "\">Film of this member</a>." : "") + "</p>\n";
}

std::string failures_list(const StudyResult& result) {
    HtmlTable table({"member", "reason"});
    for (const MemberResult& member : result.members)
        if (!member.failure.empty()) table.row({std::to_string(member.member), member.failure});
    return table.html();
}

std::string study_sentence(const StudyInput& input, const StudyFacts& facts) {
    const study::StudySpec& study = input.reading.study;
    if (study.per_polygon())
        return "one for each polygon of the release perimeter. Maps show the worst of all: what at least one of the "
               "sources causes, not all of them together.</p>\n";
    return "sampling " + study::name_of(study.sampling) + ", seed " + std::to_string(study.seed) +
           ". Standard error of the probabilities: at most " + number_text(100 * facts.error.largest, 2) +
           " %, on average " + number_text(100 * facts.error.mean, 2) +
           " % where it is not 0. It measures the number of members, not how well model, terrain and distributions "
           "describe nature.</p>\n";
}

}  // namespace

void write_study_report(const StudyInput& input, const StudyResult& result,
                        const std::vector<FigureSensitivity>& figures, const StudyFacts& facts,
                        const ResultDirectory& directory) {
    const SceneSpec& spec = input.base.spec;
    const std::string title = spec.output.title.value_or(scene_name(spec)) +
                              (input.slopes.empty() ? ": a range of runs" : ": a region of many slopes");
    HtmlPage page(directory.path(k_report_file), title,
                  std::string("Computed with ") + k_program + " " + k_version + ", study " + input.reading.study.file);
    const std::vector<std::string> maps = pictures_in(directory.path("maps")),
                                   charts = pictures_in(directory.path("charts"));
    page.expect_pictures(maps.size() + charts.size());
    page.add_warnings(facts.warnings);
    page.add("<h2 id=\"study\">Study</h2>\n<p>" + std::to_string(result.finished_at.size()) + " members of " +
             std::to_string(result.members.size()) + " finished, " + study_sentence(input, facts) +
             exposure_answer(facts.exposure, exposure_reached_by(input), words_of(spec)) + keys_table(input));
    if (!facts.levels.empty()) page.add("<h2 id=\"levels\">Levels</h2>\n" + levels_table(facts.levels));
    if (!result.figures().empty()) page.add("<h2 id=\"figures\">Figures</h2>\n" + figures_table(result));
    if (facts.median) page.add(median_paragraph(input, *facts.median, directory));
    page.add(exposure_section(facts.exposure, words_of(spec)));
    page.add(slopes_section(input, result, words_of(spec)));
    page.add("<h2 id=\"maps\">Maps</h2>\n");
    page.add_pictures(maps, "Map");
    if (!figures.empty()) page.add("<h2 id=\"sensitivity\">Sensitivity</h2>\n" + sensitivity_table(input, figures));
    if (!input.reading.study.per_polygon()) page.add("<h2 id=\"charts\">Charts</h2>\n");
    page.add_pictures(charts, "Chart");
    if (result.failed() > 0) page.add("<h2 id=\"failures\">Failed members</h2>\n" + failures_list(result));
    page.finish();
}

}  // namespace frana::app
