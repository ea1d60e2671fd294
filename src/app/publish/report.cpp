// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/pictures/charts.h"
#include "app/pictures/result_reader.h"
#include "app/publish/html_page.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/report_answer.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_tables.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

const char* const k_main_map = RasterName::max_depth;

/// "Maximum depth, at most 12 m", or the areas of the classes.
std::string range_text(const ReportInput& input, const ResultRaster& row) {
    const Words& words = input.words;
    if (row.kind == ResultRaster::Kind::classes) {
        std::vector<std::string> areas;
        for (const HazardArea& area : input.hazard)
            areas.push_back(words(area.kind.name) + " " + words.number(grouped(area.area_m2)) + " m²");
        return joined(areas, ", ");
    }
    const Raster* const raster = input.result.find_raster(row.name);
    if (raster == nullptr || raster->values.size() == 0) return "";
    double greatest = -std::numeric_limits<double>::infinity();
    raster->values.for_each_stored([&](std::size_t, double value) {
        if (std::isfinite(value)) greatest = std::max(greatest, value);
    });
    if (!std::isfinite(greatest)) return "";
    return words("maximum") + " " + words.number(number_text(greatest, 3)) +
           (row.unit.empty() || row.unit == "-" ? "" : " " + row.unit);
}

ReportMap described(const ReportInput& input, const std::string& name, const std::string& file) {
    const Words& words = input.words;
    const std::string layer = raster_of_map(name);
    const bool is_view = layer != name;
    const ResultRaster* const row = find_result_raster(layer);
    const std::string title = row == nullptr ? layer : words(row->title);
    const std::string range = row == nullptr ? "" : range_text(input, *row);
    ReportMap map{name, file, title, ""};
    if (is_view) map.caption += ", 3-D";
    if (!range.empty()) map.caption += ": " + range;
    const MainStatistics& main = input.facts.statistics;
    map.alt = map.caption + "; " +
              words.labelled(words("Covered area"), words.number(grouped(main.covered_area_m2)) + " m²; ") +
              words.labelled(words("Run-out"), words.number(grouped(main.run_out().horizontal_m)) + " m");
    return map;
}

/// Returns the maps that were drawn, the main one (greatest depth, if there is one) first.
std::vector<ReportMap> report_maps(const ReportInput& input, const ResultDirectory& directory) {
    std::vector<ReportMap> maps;
    for (const std::string& name : map_names())
        if (const std::string file = drawn_for_page(directory.folder(), directory.path("maps/" + name + ".png"));
            fs::exists(file))
            maps.push_back(described(input, name, file));
    std::stable_partition(maps.begin(), maps.end(), [](const ReportMap& map) { return map.name == k_main_map; });
    return maps;
}

/// The charts of the result's tables.
Document charts_of(const ReportInput& input, const ResultDirectory& directory) {
    MapSource source;
    source.style.words = input.words;
    Document charts;
    Problems problems;
    for (NamedChart& one : result_charts(ResultReader(directory.folder()), source, problems)) {
        one.chart.title.clear();
        one.chart.foot.clear();
        std::string alt = one.title;
        if (!one.chart.panels.empty()) alt += "; " + one.chart.panels.front().x_label;
        try {
            charts.add(Figure{"", one.title, alt, page_chart_svg(one.chart)});
        } catch (const std::exception& error) {  // the values of the page are worth more than a chart
            charts.small(input.words("{1} could not be drawn: {2}", {one.title, std::string(error.what())}));
        }
    }
    for (const Problem& problem : problems.list()) charts.small(problem.where + ": " + problem.what);
    return charts;
}

}  // namespace

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
        if (error || trend == describe(Trend::diverging))
            estimates.of[key] = {error.value_or(std::numeric_limits<double>::infinity()),
                                 trend == describe(Trend::converging)};
    }
    return estimates;
}

namespace {

/// A column of exposure.csv that reports show.
struct ShownColumn {
    const char *key, *title, *unit;
    int digits;
    double factor = 1;
};

constexpr ShownColumn k_columns[] = {{"max_depth_m", worded("Maximum depth"), "m", 3},
                                     {"max_velocity_ms", worded("Maximum velocity"), "m/s", 3},
                                     {"max_pressure_kpa", worded("Maximum dynamic pressure"), "kPa", 3},
                                     {"arrival_s", worded("Arrival time"), "s", 3},
                                     {"probability_reached", worded("Probability"), "%", 3, 100},
                                     {"sources", worded("Slopes"), "", 6}};

std::optional<double> value_of(const ReachedFeature& feature, const std::string& key) {
    const auto found = std::find_if(feature.numbers.begin(), feature.numbers.end(),
                                    [&](const auto& number) { return number.first == key; });
    if (found == feature.numbers.end()) return std::nullopt;
    return found->second;
}

}  // namespace

Document exposure_answer(const std::optional<ExposureTotals>& totals, ReachedBy by, const Words& words) {
    if (!totals) return {};
    return Document().paragraph("", exposure_sentence(*totals, by, words));
}

Document exposure_section(const std::optional<ExposureTotals>& totals, const Words& words) {
    if (!totals || totals->deepest.empty()) return {};
    std::vector<ShownColumn> shown;
    for (const ShownColumn& column : k_columns)
        if (value_of(totals->deepest.front(), column.key)) shown.push_back(column);
    std::vector<std::string> heads{words("Exposed features")};
    for (const ShownColumn& column : shown) heads.push_back(with_unit(words(column.title), column.unit));
    for (const auto& [title, names] : totals->more_columns) heads.push_back(title);
    Table table(heads);
    for (const ReachedFeature& feature : totals->deepest) {
        std::vector<Cell> cells{valid_utf8(feature.name)};
        for (const ShownColumn& column : shown) {
            const double value = column.factor * value_of(feature, column.key).value_or(k_no_data);
            cells.push_back(std::isnan(value) ? "" : words.number(number_text(value, column.digits)));
        }
        const auto told = [&](const std::string& name) {
            const auto text = std::find_if(feature.texts.begin(), feature.texts.end(),
                                           [&](const auto& one) { return one.first == name; });
            return text != feature.texts.end() ? valid_utf8(text->second)
                                               : words.number(number_text(value_of(feature, name).value_or(0), 2));
        };
        for (const auto& [title, names] : totals->more_columns) {
            std::vector<std::string> parts;
            for (const std::string& name : names) {
                parts.push_back(told(name));
                if (value_of(feature, name + "_low"))
                    parts.back() += " (" + told(name + "_low") + " – " + told(name + "_high") + ")";
                if (value_of(feature, name + "_upper")) parts.back() += " (≤ " + told(name + "_upper") + ")";
            }
            cells.push_back(joined(parts, "; "));
        }
        table.row(cells);
    }
    const std::string all =
        words("{1} of {2}; all: {3}", {std::to_string(totals->deepest.size()),
                                       words.number(grouped(static_cast<double>(totals->reached))), k_exposure_table});
    return Document().heading("exposure", words("Exposed features")).add(table).small(all);
}

namespace {

std::string hazard_heading(const SceneSpec& spec, const Words& words) {
    const std::optional<HazardScheme> scheme = hazard_scheme_of(spec);
    return scheme && scheme->has_zones() ? words(scheme->heading) : words("Intensity classes");
}

Figure figure_of(const ReportMap& map) {
    return {map.file, map.caption, map.alt};
}

void add_maps(Document& page, const ReportInput& input, const std::vector<ReportMap>& maps) {
    const Words& words = input.words;
    if (maps.size() > 1 || !input.hazard.empty()) page.heading("maps", words("Maps"));
    for (std::size_t i = 1; i < maps.size(); ++i) page.add(figure_of(maps[i]));
    if (!input.hazard.empty())
        page.box(hazard_heading(input.prepared.spec, words), hazard_table(input.prepared.spec, input.hazard, words));
}

void add_details(Document& page, const ReportInput& input, const ResultDirectory& directory) {
    const Words& words = input.words;
    page.heading("series", words("Course of the flow")).add(charts_of(input, directory));
    page.heading("values", words("Values in detail"))
        .add(answer_tables(input))
        .box(words("High values"), high_values_table(input));
    if (!input.result.released.empty()) page.box(words("Release areas"), release_table(input.result, words));
    if (input.facts.accuracy) page.box(words("Accuracy"), accuracy_tables(*input.facts.accuracy, words));
    if (input.facts.release_ground || input.facts.path_ground)
        page.box(words("Ground"), ground_table(input.facts, words));
    if (const auto& friction = input.facts.friction)
        page.box(words("Friction by place"), friction_table(*friction, input.facts.friction_areas, words));
    page.columns(Document()
                     .box(words("Mass budget"), budget_table(input.result, words))
                     .box(words("Numerical checks"), numerics_table(input)));
}

void add_keys(Document& page, const ReportInput& input) {
    const Words& words = input.words;
    page.heading("parameters", words("Keys used"))
        .small(words("Bold: given"))
        .small(words.labelled(words("default"), joined(left_at_default(input.prepared), ", ")))
        .add(parameters_table(input.prepared, true, words))
        .folded(words("All keys"), parameters_table(input.prepared, false, words));
}

}  // namespace

void write_report(const ReportInput& input, const ResultDirectory& directory) {
    const SceneSpec& spec = input.prepared.spec;
    const Words& words = input.words;
    const std::string title = spec.output.title.value_or(scene_name(spec));
    const std::vector<ReportMap> maps = report_maps(input, directory);
    Document page = answer(input);
    if (!maps.empty()) page.add(figure_of(maps.front()));
    page.add(scenario(input)).end_answer();
    add_maps(page, input, maps);
    page.add(comparison_section(input.comparison, drawn_for_page(directory.folder(), directory.path("comparison.png")),
                                words));
    page.add(exposure_section(input.facts.exposure, words));
    add_details(page, input, directory);
    if (!input.facts.warnings.empty()) page.warnings(input.facts.warnings, words);
    page.heading("inputs", words("Inputs")).add(inputs_table(input.prepared, words));
    add_keys(page, input);
    write_page(directory.folder(),
               {title,
                std::string(k_program) + " " + k_version + "; " + fs::path(spec.file).filename().string() + "; " +
                    provenance(input.prepared).at("SCENE_HASH"),
                words, maps.empty() ? Opening::answer : Opening::answer_with_picture},
               page);
}

}  // namespace frana::app
