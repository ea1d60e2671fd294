// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_report.h"

#include <algorithm>
#include <filesystem>

#include "app/ensemble/region_report.h"
#include "app/ensemble/study_answer.h"
#include "app/ensemble/study_charts.h"
#include "app/ensemble/study_exposure.h"
#include "app/input/scene_language.h"
#include "app/publish/html_page.h"
#include "app/publish/html_table.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_exposure.h"
#include "app/publish/report_numbers.h"
#include "app/publish/report_tables.h"
#include "app/store/result_files.h"
#include "app/text/version.h"
#include "core/markup.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_figures_on_first_page = 12;

std::string keys_table(const StudyInput& input, const Words& words) {
    HtmlTable table({words("key"), words("distribution")});
    for (const study::Variation& one : input.reading.study.vary) table.row({one.key, one.distribution.text});
    for (const study::Correlation& one : input.reading.study.correlate)
        table.row(
            {one.first + ", " + one.second, words("rank correlation {1}", {words.number(shortest_text(one.rho))})});
    return table.html();
}

std::string levels_table(const std::vector<LevelSummary>& levels, const Words& words) {
    const ReportNumbers number(words);
    double all = 0;
    for (const LevelSummary& level : levels) all += level.statistics.cost * static_cast<double>(level.members);
    HtmlTable table({words("level"), words("cells [m]"), words("members"),
                     words("variance of the difference, of that on level 0 [%]"), words("part of the cost [%]")});
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const LevelSummary& level = levels[l];
        const double cost = level.statistics.cost * static_cast<double>(level.members);
        table.row({std::to_string(l), number(level.cell_size), std::to_string(level.members),
                   number.percent(level.statistics.variance / levels.front().statistics.variance),
                   number.percent(cost / all)});
    }
    return table.html();
}

std::string interval_text(const std::optional<study::Interval>& one, const Words& words) {
    if (!one) return "";
    const ReportNumbers number(words);
    return words("{1} ({2} to {3})", {number(one->value, 2), number(one->low, 2), number(one->high, 2)});
}

std::string sensitivity_table(const StudyInput& input, const std::vector<FigureSensitivity>& figures,
                              const Words& words) {
    HtmlTable table({words("value"), words("key"), words("first order"), words("total"), words("rank correlation"),
                     words("method")});
    for (const FigureSensitivity& figure : figures)
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const study::KeySensitivity& one = figure.keys[k];
            table.row({figure_title(figure.figure, words), input.table.keys[k], interval_text(one.first_order, words),
                       interval_text(one.total, words), interval_text(one.rank_correlation, words),
                       one.method.empty() ? words("not measurable") : one.method});
        }
    return table.html() + "<p class=\"small\">" +
           escaped_markup(words("What part of the variance of a value its key explains, alone (first order) and with "
                                "others (total), or how the two are correlated; in brackets the interval of 95 %.")) +
           "</p>\n";
}

std::string median_paragraph(const StudyInput& input, const MedianMember& median, const ResultDirectory& directory,
                             const Words& words) {
    const ReportNumbers number(words);
    std::string values;
    for (const std::string& one : input.table.overrides(median.member)) values += (values.empty() ? "" : ", ") + one;
    std::string html = escaped_markup(
        words("Member {1}: {2} {3} {4}, nearest to the weighted median of all, {5}. Its values: {6}.",
              {std::to_string(median.member), figure_title(median.figure, words), number.grouped(median.figure.value),
               ReportNumbers::unit(median.figure.unit), number.grouped(median.median), values}));
    if (fs::exists(directory.path(k_animation_file)))
        html += std::string(" <a href=\"") + k_animation_file + "\">" + escaped_markup(words("Film of this member")) +
                "</a>.";
    return "<p>" + html + "</p>\n";
}

std::string failures_list(const StudyResult& result, const Words& words) {
    HtmlTable table({words("member"), words("reason")});
    for (const MemberResult& member : result.members)
        if (!member.failure.empty()) table.row({std::to_string(member.member), member.failure});
    return table.html();
}

/// Puts the pictures of these names first, in their order.
std::vector<std::string> with_first(const std::vector<std::string>& names, std::vector<std::string> pictures) {
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        const auto found = std::find_if(pictures.begin(), pictures.end(),
                                        [&](const std::string& picture) { return fs::path(picture).stem() == *name; });
        if (found != pictures.end()) std::rotate(pictures.begin(), found, found + 1);
    }
    return pictures;
}

/// The map that answers the question of the study first.
std::vector<std::string> maps_in_order(const StudyInput& input, const ResultDirectory& directory) {
    const std::vector<double>& depths = input.base.spec.output.depth_thresholds;
    const std::string of_runs = depths.empty() ? "" : "probability_depth_" + shortest_text(depths.front());
    return with_first({of_runs, "hazard_degree", "union_max_depth"}, pictures_in(directory.path("maps")));
}

std::string title_of(const StudyInput& input, const Words& words) {
    const SceneSpec& spec = input.base.spec;
    const std::string name = spec.output.title.value_or(scene_name(spec));
    return !input.slopes.empty()               ? words("{1}: a region of many slopes", {name})
           : input.reading.study.per_polygon() ? words("{1}: each source alone", {name})
                                               : words("{1}: a range of runs", {name});
}

void add_inputs(const StudyInput& input, const StudyFacts& facts, const Words& words, HtmlPage& page) {
    page.add_heading("inputs", words("Distributions and inputs"));
    if (!input.reading.study.vary.empty()) page.add(keys_table(input, words));
    if (!facts.levels.empty())
        page.add("<h3>" + escaped_markup(words("Levels")) + "</h3>\n" + levels_table(facts.levels, words));
    page.add(inputs_table(input.base, words));
    page.add("<details>\n<summary>" + escaped_markup(words("Keys used")) + "</summary>\n" +
             parameters_table(input.base, true, words) + "</details>\n");
}

}  // namespace

void write_study_report(const StudyInput& input, const StudyResult& result,
                        const std::vector<FigureSensitivity>& figures, const StudyFacts& facts,
                        const ResultDirectory& directory) {
    const Words words = words_of(input.base.spec);
    const std::vector<std::string> maps = maps_in_order(input, directory),
                                   charts = with_first({"exceedance", "sensitivity", "convergence"},
                                                       pictures_in(directory.path("charts")));
    HtmlPage page(directory.path(k_report_file), title_of(input, words),
                  words("Computed with {1}, study {2}, {3}",
                        {std::string(k_program) + " " + k_version,
                         fs::path(input.reading.study.file).filename().string(), words.date(facts.date)}),
                  words, maps.empty() ? Opening::answer : Opening::answer_with_picture);
    page.expect_pictures(maps.size() + charts.size() + 1);
    page.add(study_answer(input, result, facts, words) +
             exposure_answer(facts.exposure, exposure_reached_by(input), words));
    if (!maps.empty()) page.add_pictures({maps.front()}, words("Map"));
    // The first page of paper has room for a short table under its picture.
    const bool is_short = input.reading.study.per_polygon() || result.figures().size() <= k_figures_on_first_page;
    if (is_short) page.add(study_values(input, result, facts, words));
    page.end_answer();
    if (!is_short) page.add(study_values(input, result, facts, words));
    page.add(study_sources(input, result, words) + exposure_section(facts.exposure, words) +
             slopes_section(input, result, words));
    page.add_heading("maps", words("Maps"));
    if (maps.size() > 1) page.add_pictures({maps.begin() + 1, maps.end()}, words("Map"));
    if (maps.size() == 1) page.add("<p>" + escaped_markup(words("The only map is on the first page.")) + "</p>\n");
    if (maps.empty()) page.add("<p>" + escaped_markup(words("There are no maps.")) + "</p>\n");
    page.add(page_part(k_comparison_section, ""));
    add_inputs(input, facts, words, page);
    if (!figures.empty()) {
        page.add_heading("sensitivity", words("Sensitivity"));
        page.add(sensitivity_table(input, figures, words));
    }
    if (!charts.empty()) {
        page.add_heading("charts", words("Charts"));
        page.add_pictures(charts, words("Chart"));
    }
    if (facts.median) {
        page.add_heading("median", words("Median member"));
        page.add(median_paragraph(input, *facts.median, directory, words));
    }
    if (!facts.warnings.empty()) page.add_warnings(facts.warnings);
    if (result.failed() > 0) {
        page.add_heading("failures", words("Failed members"));
        page.add(failures_list(result, words));
    }
    page.finish();
    remove_page_pictures(directory.folder());
}

}  // namespace frana::app
