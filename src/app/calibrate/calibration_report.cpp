// SPDX-License-Identifier: Apache-2.0
#include "app/calibrate/calibration_report.h"

#include <cmath>

#include "app/publish/html_page.h"
#include "app/publish/html_table.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/markup.h"

namespace frana::app {
namespace {

std::string range(double low, double high) {
    return number_text(low, 3) + " to " + number_text(high, 3);
}

std::string keys_table(const CalibrationInput& input, const CalibrationResult& result) {
    HtmlTable table({"key", "distribution before", "best", "median", "90 % after", "width, of that before"});
    for (std::size_t k = 0; k < result.keys.size(); ++k) {
        const study::KeySample& key = result.keys[k];
        const study::KeyPosterior& after = result.posteriors[k];
        std::string probabilities;
        for (const auto& [value, probability] : after.values)
            probabilities += (probabilities.empty() ? "" : ", ") + value + ": " + number_text(probability, 2);
        const std::string best = after.nominal ? key.texts[result.best] : number_text(key.numbers[result.best], 4);
        table.row(after.nominal ? std::vector<std::string>{column_of(input.spec(), key), key.prior.text, best, "",
                                                           probabilities, ""}
                                : std::vector<std::string>{column_of(input.spec(), key), key.prior.text, best,
                                                           number_text(after.median, 3), range(after.low, after.high),
                                                           number_text(after.width, 2)});
    }
    return table.html();
}

std::vector<std::string> scores_row(const std::string& event, const std::string& kind, const Explained& one) {
    if (!one.possible) return {event, kind, "no member finished", "", "", ""};
    return {event,
            kind,
            number_text(one.best_score, 3),
            number_text(one.mean, 3),
            range(one.low, one.high),
            number_text(one.effective, 3)};
}

std::string scores_table(const CalibrationInput& input, const CalibrationResult& result) {
    HtmlTable table({"event", "values", "score of the best", "mean", "5 to 95 %", "effective members"});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::string& event = input.spec().events[e].name;
        table.row(scores_row(event, "fitted to all surveys", result.events[e].fitted));
        if (input.events() > 1)
            table.row(scores_row(event, "from the other surveys alone", result.events[e].predicted));
    }
    return table.html();
}

std::string misfits_table(const CalibrationInput& input, const CalibrationRuns& runs, const CalibrationResult& result) {
    HtmlTable table({"event", "measure", "weight", "misfit of the best", "formula"});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.last().events[e];
        for (std::size_t m = 0; m < event.measures.size(); ++m) {
            const study::MeasureRow& measure = row_of(event.measures[m].measure);
            table.row({input.spec().events[e].name, measure.name, number_text(event.measures[m].weight),
                       number_text(event.members[result.best].agreement.parts[m], 3), measure.formula});
        }
    }
    return table.html();
}

std::string failures_table(const CalibrationInput& input, const Stage& stage) {
    HtmlTable table({"member", "event", "reason"});
    for (std::size_t e = 0; e < input.events(); ++e)
        for (std::size_t i = 0; i < stage.size(); ++i)
            if (const std::string& why = stage.events[e].members[i].failure; !why.empty())
                table.row({std::to_string(i), input.spec().events[e].name, why});
    return table.html();
}

}  // namespace

std::string calibration_title(const CalibrationInput& input) {
    std::string names;
    for (const study::EventSpec& event : input.spec().events) names += (names.empty() ? "" : ", ") + event.name;
    return names;
}

void write_calibration_report(const CalibrationInput& input, const CalibrationRuns& runs,
                              const CalibrationResult& result, const CalibrationFacts& facts,
                              const ResultDirectory& directory) {
    HtmlPage page(directory.path(k_report_file), calibration_title(input) + ": calibration",
                  std::string("Computed with ") + k_program + " " + k_version + ", study " + input.spec().study.file);
    const std::vector<std::string> charts = pictures_in(directory.path("charts"));
    page.expect_pictures(charts.size());
    page.add_warnings(facts.warnings);
    std::string cells;
    for (const EventRuns& event : runs.last().events)
        cells += (cells.empty() ? "" : ", ") + number_text(event.cell_size);
    page.add("<h2 id=\"says\">What the surveys say</h2>\n<ul>\n");
    for (const std::string& sentence : result.sentences) page.add("<li>" + escaped_markup(sentence) + "</li>\n");
    page.add("</ul>\n<p>" + std::to_string(runs.design.size()) + " first members, then " +
             std::to_string(runs.refined ? runs.refined->size() : 0) +
             " where these explain the surveys, on cells of " + cells + " m; effective number " +
             number_text(result.effective, 3) +
             ". A score is 1 minus the misfit: 1 agrees. Likelihood of an event: misfit to the power of -" +
             number_text(result.exponent, 2) + ".</p>\n");
    page.add("<h2 id=\"values\">Values</h2>\n" + keys_table(input, result));
    page.add("<h2 id=\"scores\">How well the events are explained</h2>\n" + scores_table(input, result) +
             (input.events() > 1
                  ? ""
                  : "<p>With one event there is no forecast to check: the score is that of a fit.</p>\n") +
             misfits_table(input, runs, result));
    page.add("<h2 id=\"charts\">Charts</h2>\n");
    page.add_pictures(charts, "Chart");
    if (runs.last().failed() > 0)
        page.add("<h2 id=\"failures\">Failed members</h2>\n" + failures_table(input, runs.last()));
    page.finish();
}

}  // namespace frana::app
