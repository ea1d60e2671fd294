// SPDX-License-Identifier: Apache-2.0
#include "app/calibrate/calibration_report.h"

#include <cmath>
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

std::string range(double low, double high) {
    return number_text(low, 3) + " to " + number_text(high, 3);
}

std::string keys_table(const CalibrationInput& input, const CalibrationResult& result) {
    std::string html =
        "<table>\n" +
        table_row({"key", "distribution before", "best", "median", "90 % after", "width, of that before"}, "th");
    for (std::size_t k = 0; k < result.keys.size(); ++k) {
        const study::KeySample& key = result.keys[k];
        const study::KeyPosterior& after = result.posteriors[k];
        std::string probabilities;
        for (const auto& [value, probability] : after.values)
            probabilities += (probabilities.empty() ? "" : ", ") + value + ": " + number_text(probability, 2);
        const std::string best = after.nominal ? key.texts[result.best] : number_text(key.numbers[result.best], 4);
        html += after.nominal
                    ? table_row({column_of(input.spec(), key), key.prior.text, best, "", probabilities, ""})
                    : table_row({column_of(input.spec(), key), key.prior.text, best, number_text(after.median, 3),
                                 range(after.low, after.high), number_text(after.width, 2)});
    }
    return html + "</table>\n";
}

std::string scores_row(const std::string& event, const std::string& kind, const Explained& one) {
    if (!one.possible) return table_row({event, kind, "no member finished", "", "", ""});
    return table_row({event, kind, number_text(one.best_score, 3), number_text(one.mean, 3), range(one.low, one.high),
                      number_text(one.effective, 3)});
}

std::string scores_table(const CalibrationInput& input, const CalibrationResult& result) {
    std::string html =
        "<table>\n" +
        table_row({"event", "values", "score of the best", "mean", "5 to 95 %", "effective members"}, "th");
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::string& event = input.spec().events[e].name;
        html += scores_row(event, "fitted to all surveys", result.events[e].fitted);
        if (input.events() > 1) html += scores_row(event, "from the other surveys alone", result.events[e].predicted);
    }
    return html + "</table>\n";
}

std::string misfits_table(const CalibrationInput& input, const CalibrationRuns& runs, const CalibrationResult& result) {
    std::string html = "<table>\n" + table_row({"event", "measure", "weight", "misfit of the best", "formula"}, "th");
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.last().events[e];
        for (std::size_t m = 0; m < event.measures.size(); ++m) {
            const study::MeasureRow& measure = row_of(event.measures[m].measure);
            html += table_row({input.spec().events[e].name, measure.name, number_text(event.measures[m].weight),
                               number_text(event.members[result.best].agreement.parts[m], 3), measure.formula});
        }
    }
    return html + "</table>\n";
}

void add_pictures(const std::string& folder, HtmlPage& page) {
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder)))
        if (entry.path().extension() == ".png") page.add_picture(entry.path().string(), entry.path().stem().string());
}

std::string failures_table(const CalibrationInput& input, const Stage& stage) {
    std::string html = "<table>\n" + table_row({"member", "event", "reason"}, "th");
    for (std::size_t e = 0; e < input.events(); ++e)
        for (std::size_t i = 0; i < stage.size(); ++i)
            if (const std::string& why = stage.events[e].members[i].failure; !why.empty())
                html += table_row({std::to_string(i), input.spec().events[e].name, why});
    return html + "</table>\n";
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
    page.add("<h2 id=\"maps\">Maps</h2>\n");
    add_pictures(directory.path("maps"), page);
    page.add("<h2 id=\"charts\">Charts</h2>\n");
    add_pictures(directory.path("charts"), page);
    if (runs.last().failed() > 0)
        page.add("<h2 id=\"failures\">Failed members</h2>\n" + failures_table(input, runs.last()));
    page.finish();
}

}  // namespace frana::app
