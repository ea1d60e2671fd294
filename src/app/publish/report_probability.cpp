// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_probability.h"

#include "app/compare/probability_comparison.h"
#include "app/pictures/charts.h"
#include "app/pictures/class_words.h"
#include "app/publish/html_page.h"
#include "app/publish/html_table.h"
#include "app/publish/renewed_page.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_numbers.h"
#include "app/publish/report_scenario.h"
#include "core/markup.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

std::string map_title(const ProbabilityMap& map, const Words& words) {
    const ResultRaster* const row = find_result_raster(map.name);
    return row == nullptr ? map.name : raster_title(*row, map.name, words);
}

std::string answer(const ProbabilityScores& scores, const ProbabilityMap& map, const Words& words) {
    const ReportNumbers number(words);
    return paragraph(words("Against the survey."),
                     words("{1}: Brier score {2} (0: perfect), skill {3} (1: perfect, 0: as good as the mean "
                           "everywhere), area under the ROC curve {4} (1: perfect).",
                           {map_title(map, words), number(scores.brier, 3), number(scores.brier_skill, 3),
                            number(scores.auroc, 3)}));
}

std::string section(const ProbabilityScores& scores, const ProbabilityMap& map, const Words& words) {
    const ReportNumbers number(words);
    HtmlTable table;
    table.number(words("Observed area"), number.grouped(scores.observed_area_m2), "m²")
        .number(words("Brier score, best 0"), number(scores.brier, 3), "")
        .number(words("Brier skill, best 1"), number(scores.brier_skill, 3), "")
        .number(words("Reliability: how far the probabilities are from those observed, best 0"),
                number(scores.reliability, 3), "")
        .number(words("Resolution: how far they differ from the mean"), number(scores.resolution, 3), "")
        .number(words("Area under the ROC curve, best 1"), number(scores.auroc, 3), "");
    std::string html = "<h2 id=\"comparison\">" + escaped_markup(words("Comparison with the survey")) + "</h2>\n";
    html += svg_figure(
        page_chart_svg(probability_chart(scores, map)), map_title(map, words),
        words("Reliability of the probabilities, and their ROC curve with an area of {1}", {number(scores.auroc, 3)}));
    return html + table.html();
}

}  // namespace

bool renew_report(const std::string& folder, const ProbabilityScores& scores, const ProbabilityMap& map) {
    return renew_page(folder, [&](const Words& words) {
        return std::vector<PagePart>{{k_comparison_answer, answer(scores, map, words)},
                                     {k_comparison_section, section(scores, map, words)}};
    });
}

}  // namespace frana::app
