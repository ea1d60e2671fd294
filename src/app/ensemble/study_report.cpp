// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_report.h"

#include <filesystem>

#include "app/publish/html_page.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/folder_entries.h"
#include "core/markup.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string row(const std::vector<std::string>& cells, const char* cell = "td") {
    std::string html = "<tr>";
    for (const std::string& text : cells)
        html += std::string("<") + cell + ">" + escaped_markup(text) + "</" + cell + ">";
    return html + "</tr>\n";
}

std::string keys_table(const StudyInput& input) {
    std::string html = "<table>\n" + row({"key", "distribution"}, "th");
    for (const study::Variation& one : input.reading.study.vary) html += row({one.key, one.distribution.text});
    for (const study::Correlation& one : input.reading.study.correlate)
        html += row({one.first + " and " + one.second, "rank correlation " + number_text(one.rho)});
    return html + "</table>\n";
}

std::string figures_table(const StudyResult& result) {
    std::string html = "<table>\n" + row({"figure", "unit", "mean", "5 %", "50 %", "95 %"}, "th");
    const std::vector<double>& weights = result.finished.weights;
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        const std::vector<double> values = result.figure(f);
        html += row({result.figures()[f].title, result.figures()[f].unit, number_text(weighted_mean(values, weights)),
                     number_text(figure_quantile(values, weights, 0.05)),
                     number_text(figure_quantile(values, weights, 0.5)),
                     number_text(figure_quantile(values, weights, 0.95))});
    }
    return html + "</table>\n";
}

std::string interval_text(const std::optional<study::Interval>& one) {
    if (!one) return "";
    return number_text(one->value, 2) + " (" + number_text(one->low, 2) + " to " + number_text(one->high, 2) + ")";
}

std::string sensitivity_table(const StudyInput& input, const std::vector<FigureSensitivity>& figures) {
    std::string html = "<table>\n" + row({"figure", "key", "first order", "total", "rank correlation", "method"}, "th");
    for (const FigureSensitivity& figure : figures)
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const study::KeySensitivity& one = figure.keys[k];
            html +=
                row({figure.figure.title, input.table.keys[k], interval_text(one.first_order), interval_text(one.total),
                     interval_text(one.rank_correlation), one.method.empty() ? "not measurable" : one.method});
        }
    return html + "</table>\n";
}

void add_pictures(const std::string& folder, HtmlPage& page) {
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder)))
        if (entry.path().extension() == ".png") page.add_picture(entry.path().string(), entry.path().stem().string());
}

std::string failures_list(const StudyResult& result) {
    std::string html = "<table>\n" + row({"member", "reason"}, "th");
    for (const MemberResult& member : result.members)
        if (!member.failure.empty()) html += row({std::to_string(member.member), member.failure});
    return html + "</table>\n";
}

}  // namespace

void write_study_report(const StudyInput& input, const StudyResult& result,
                        const std::vector<FigureSensitivity>& figures, const StudyFacts& facts,
                        const ResultDirectory& directory) {
    const SceneSpec& spec = input.base.spec;
    const std::string title = spec.output.title.value_or(scene_name(spec)) + ": a range of runs";
    HtmlPage page(directory.path(k_report_file), title,
                  std::string("Computed with ") + k_program + " " + k_version + ", study " + input.reading.study.file);
    page.add_warnings(facts.warnings);
    page.add("<h2 id=\"study\">Study</h2>\n<p>" + std::to_string(result.finished_at.size()) + " members of " +
             std::to_string(result.members.size()) + " finished, sampling " +
             study::name_of(input.reading.study.sampling) + ", seed " + std::to_string(input.reading.study.seed) +
             ". Standard error of the probabilities: at most " + number_text(100 * facts.error.largest, 2) +
             " %, on average " + number_text(100 * facts.error.mean, 2) +
             " % where it is not 0. It measures the number of members, not how well model, terrain and distributions "
             "describe nature.</p>\n" +
             keys_table(input));
    if (!result.figures().empty()) page.add("<h2 id=\"figures\">Figures</h2>\n" + figures_table(result));
    page.add("<h2 id=\"maps\">Maps</h2>\n");
    add_pictures(directory.path("maps"), page);
    if (!figures.empty()) page.add("<h2 id=\"sensitivity\">Sensitivity</h2>\n" + sensitivity_table(input, figures));
    page.add("<h2 id=\"charts\">Charts</h2>\n");
    add_pictures(directory.path("charts"), page);
    if (result.failed() > 0) page.add("<h2 id=\"failures\">Failed members</h2>\n" + failures_list(result));
    page.finish();
}

}  // namespace frana::app
