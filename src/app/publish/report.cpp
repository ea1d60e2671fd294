// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/publish/html_page.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/report_answer.h"
#include "app/publish/report_charts.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_maps.h"
#include "app/publish/report_tables.h"
#include "app/store/json_file.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/text.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

std::optional<ErrorEstimates::Estimate> ErrorEstimates::find(const std::string& key) const {
    const auto found = of.find(key);
    return found == of.end() ? std::nullopt : std::optional(found->second);
}

ErrorEstimates error_estimates(const SummaryFacts& facts, const std::string& result) {
    ErrorEstimates estimates;
    if (facts.accuracy) {
        for (const ValueEstimate& one : value_estimates(*facts.accuracy))
            if (!one.is_zero) estimates.of[one.value.key] = {one.error, one.convergence.trend == Trend::converging};
        return estimates;
    }
    if (!read_error_estimate(result, facts.spec)) return estimates;
    const auto file = std::filesystem::path(convergence_directory(result)) / k_convergence_file;
    const std::optional<Json> study = read_json_file(file.string());
    if (!study || !study->contains("statistics")) return estimates;
    estimates.from_study = true;
    for (const auto& [key, value] : study->at("statistics").items()) {
        const auto error = value_in<double>(value, "/estimated_error");
        const auto trend = value_in<std::string>(value, "/trend");
        if (error) estimates.of[key] = {*error, trend == describe(Trend::converging)};
    }
    return estimates;
}

namespace {

/// A column of exposure.csv that reports show.
struct ShownColumn {
    const char *key, *title;
    int digits;
    double factor = 1;
};

constexpr ShownColumn k_columns[] = {{"max_depth_m", worded("Greatest depth [m]"), 3},
                                     {"max_velocity_ms", worded("Greatest speed [m/s]"), 3},
                                     {"max_pressure_kpa", worded("Greatest pressure [kPa]"), 3},
                                     {"arrival_s", worded("First arrival [s]"), 3},
                                     {"probability_reached", worded("Probability that it is reached [%]"), 3, 100},
                                     {"sources", worded("Slopes that reach it"), 6}};

std::optional<double> value_of(const ReachedFeature& feature, const std::string& key) {
    const auto found = std::find_if(feature.numbers.begin(), feature.numbers.end(),
                                    [&](const auto& number) { return number.first == key; });
    if (found == feature.numbers.end()) return std::nullopt;
    return found->second;
}

}  // namespace

Document exposure_answer(const std::optional<ExposureTotals>& totals, ReachedBy by, const Words& words) {
    if (!totals) return {};
    return Document().paragraph(words("What is exposed."), exposure_sentence(*totals, by, words));
}

Document exposure_section(const std::optional<ExposureTotals>& totals, const Words& words) {
    if (!totals || totals->deepest.empty()) return {};
    std::vector<ShownColumn> shown;
    for (const ShownColumn& column : k_columns)
        if (value_of(totals->deepest.front(), column.key)) shown.push_back(column);
    std::vector<std::string> heads{words("Feature")};
    for (const ShownColumn& column : shown) heads.push_back(words(column.title));
    Table table(heads);
    for (const ReachedFeature& feature : totals->deepest) {
        std::vector<Cell> cells{valid_utf8(feature.name)};
        for (const ShownColumn& column : shown) {
            const double value = column.factor * value_of(feature, column.key).value_or(k_no_data);
            cells.push_back(std::isnan(value) ? "" : words.number(number_text(value, column.digits)));
        }
        table.row(cells);
    }
    const std::string all = totals->reached > totals->deepest.size()
                                ? words("The {1} deepest of {2}; {3} has all.",
                                        {std::to_string(totals->deepest.size()),
                                         words.number(grouped(static_cast<double>(totals->reached))), k_exposure_table})
                                : words("{1} has all features, also those that are not reached.", {k_exposure_table});
    return Document().heading("exposure", words("Exposed features that are reached")).add(table).small(all);
}

namespace {

namespace fs = std::filesystem;

std::string hazard_heading(const SceneSpec& spec, const Words& words) {
    const std::optional<HazardScheme> scheme = hazard_scheme_of(spec);
    return scheme && scheme->title != k_intensity_title ? words(scheme->title) : words("Intensity classes");
}

Figure figure_of(const ReportMap& map) {
    return {map.file, map.caption, map.alt};
}

void add_maps(Document& page, const ReportInput& input, const std::vector<ReportMap>& maps) {
    const Words& words = input.words;
    page.heading("maps", words("Maps"));
    if (maps.empty())
        page.small(input.prepared.spec.output.maps.front() == "off"
                       ? words("The scene asks for no maps.")
                       : words("No map could be drawn; see the warnings."));
    if (maps.size() == 1) page.small(words("The only map is on the first page."));
    for (std::size_t i = 1; i < maps.size(); ++i) page.add(figure_of(maps[i]));
    if (!input.hazard.empty())
        page.box(hazard_heading(input.prepared.spec, words), hazard_table(input.prepared.spec, input.hazard, words));
}

void add_details(Document& page, const ReportInput& input) {
    const Words& words = input.words;
    page.heading("series", words("Course of the flow")).add(series_charts(input));
    page.heading("values", words("Values in detail")).box(words("High values"), high_values_table(input));
    if (!input.result.released.empty()) page.box(words("Release areas"), release_table(input.result, words));
    if (input.facts.accuracy) page.box(words("Accuracy"), accuracy_tables(*input.facts.accuracy, words));
    if (input.facts.release_ground || input.facts.path_ground)
        page.box(words("Ground"), ground_table(input.facts, words));
    page.columns(Document()
                     .box(words("Mass budget"), budget_table(input.result, words))
                     .box(words("Numerical checks"), numerics_table(input)))
        .small(terms_note(input));
}

void add_keys(Document& page, const ReportInput& input) {
    const Words& words = input.words;
    page.heading("parameters", words("Keys used"))
        .small(words("Bold: given in the scene, on the command line or by the material preset. Keys that the scene "
                     "does not use are left out."))
        .add(parameters_table(input.prepared, true, words))
        .folded(words("All keys"), parameters_table(input.prepared, false, words));
}

}  // namespace

void write_report(const ReportInput& input, const ResultDirectory& directory) {
    const SceneSpec& spec = input.prepared.spec;
    const Words& words = input.words;
    const std::string title = spec.output.title.value_or(scene_name(spec));
    const std::vector<ReportMap> maps = report_maps(input, directory);
    Document page = answer_sentences(input);
    if (!maps.empty()) page.add(figure_of(maps.front()));
    page.add(answer_tables(input)).end_answer();
    add_maps(page, input, maps);
    page.part(k_comparison_section,
              comparison_section(input.comparison, drawn_for_page(directory.folder(), directory.path("comparison.png")),
                                 words));
    page.add(exposure_section(input.facts.exposure, words));
    add_details(page, input);
    if (!input.facts.warnings.empty()) page.warnings(warnings_of(input), words);
    page.heading("inputs", words("Inputs")).add(inputs_table(input.prepared, words));
    add_keys(page, input);
    write_page(directory.folder(),
               {title,
                words("Computed with {1}, scene {2}, hash {3}",
                      {std::string(k_program) + " " + k_version, fs::path(spec.file).filename().string(),
                       provenance(input.prepared).at("SCENE_HASH")}),
                words, maps.empty() ? Opening::answer : Opening::answer_with_picture},
               page);
}

}  // namespace frana::app
