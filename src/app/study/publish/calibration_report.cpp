// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_calibration.h"

#include <algorithm>
#include <filesystem>

#include "analysis/trace.h"
#include "app/compare/comparison.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/publish/html_page.h"
#include "app/publish/publish_rasters.h"
#include "app/publish/report_answer.h"
#include "app/publish/report_tables.h"
#include "app/store/result_files.h"
#include "app/study/publish/map_writer.h"
#include "app/study/publish/study_files.h"
#include "app/study/statistics/study_maps.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/raster/footprint.h"
#include "params/keys/output_parameters.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"

namespace frana::app::study {

namespace {

/// How a calibration's maps and charts look: as the scene's keys ask.
MapStyle calibration_style(const SceneSpec& scene) {
    const OutputSpec& output = scene.output;
    MapStyle style;
    style.words = words_of(scene);
    if (const auto size = size_from_text(output.map_size)) style.size = *size;
    style.formats = output.map_formats;
    style.attribution = output.map_attribution.value_or("");
    style.author = output.map_author.value_or("");
    style.date = date_on_maps(output.map_date, today());
    return style;
}

constexpr Rgb k_best_colour{200, 60, 20};

/// The part of a grid round the cells that a member reached, with a margin.
CellWindow window_of(const FinishedMembers& members, const GridSpec& grid) {
    constexpr std::int64_t k_margin = 16;
    const CellWindow reached = reached_window(members, grid);
    const std::int64_t top = std::clamp<std::int64_t>(reached.row - k_margin, 0, grid.rows),
                       left = std::clamp<std::int64_t>(reached.column - k_margin, 0, grid.columns),
                       bottom = std::clamp<std::int64_t>(reached.row + reached.rows + k_margin, top, grid.rows),
                       right =
                           std::clamp<std::int64_t>(reached.column + reached.columns + k_margin, left, grid.columns);
    return {top, left, bottom - top, right - left};
}

/// The runs of an event that the surveys give weight.
OpenRuns weighted_runs(const EventRuns& event, const CalibrationResult& result) {
    OpenRuns all;
    const RecordFiles records(event.records);
    for (std::size_t i = 0; i < result.weights.size(); ++i) {
        if (!(result.weights[i] > 0)) continue;
        all.runs.records.push_back(records.place(i));
        all.runs.weights.push_back(result.weights[i]);
        all.is_open.push_back(event.members[i].end.is_open());
    }
    return all;
}

MapSource source_of(const StudyInput& input, std::size_t e, const EventRuns& runs, const CalibrationResult& result,
                    const CellWindow& window, const Troubles& troubles) {
    const Prepared& base = input.own[e].base;
    const double threshold = observed_threshold(base.spec);
    MapSource source;
    source.style = calibration_style(base.spec);
    const Words& words = source.style.words;
    source.title = base.spec.output.title.value_or(input.spec().events[e].name);
    const auto number = [&](double value) { return words.number(number_text(value, 3)); };
    const auto weighted = std::count_if(result.weights.begin(), result.weights.end(), [](double w) { return w > 0; });
    source.subtitle = words("{1} runs weighted by the surveys, effective number {2}",
                            {std::to_string(weighted), number(result.effective)});
    source.notes = {words("Deeper than {1} m counts", {number(threshold)})};
    if (troubles.are_first())
        source.scenario = headline(troubles).in(words) + ". " + source.subtitle;
    else if (troubles.any())
        source.notes.push_back(headline(troubles).in(words));
    if (troubles.flew > 0) source.notes.push_back(words(k_high_flights));
    source.terrain = part_of(base.scene.terrain, window);
    const GridSpec& grid = source.terrain.grid;
    source.crs_label = gis::crs_name(grid.crs_wkt);
    source.convergence_deg =
        gis::meridian_convergence_deg(grid.crs_wkt, {(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    source.longitude_latitude = longitude_latitude(grid.crs_wkt);
    for (std::size_t i = 0; i < base.scene.release.size(); ++i) {
        const PolygonFeature outline = release_outline(base.scene.release[i], i);
        source.release.insert(source.release.end(), outline.parts.begin(), outline.parts.end());
    }
    source.scar = surveyed(base).survey.scar;
    if (const auto best = read_record(RecordFiles(runs.records).place(result.best)))
        source.marks.push_back({words("Best run"),
                                gis::polygonise(trace_mask(best->raster(Quantity::depth, grid), threshold)),
                                k_best_colour, 1.8, true});
    return source;
}

}  // namespace

void publish_calibration_maps(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const Troubles& troubles, const ResultDirectory& directory, RunLog& log) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const Prepared& base = input.own[e].base;
        const OpenRuns weighted = weighted_runs(runs.events[e], result);
        const CellWindow window = window_of(weighted.runs, base.scene.grid);
        if (window.rows == 0 || window.columns == 0) continue;
        const std::string name = "posterior_" + input.spec().events[e].name;
        MapWriter(base, directory)
            .write_probabilities(weighted.runs, weighted, part_of(base.scene.grid, window),
                                 {Quantity::depth, {observed_threshold(base.spec)}, {name}});
        if (base.spec.output.maps.front() == "off") continue;
        directory.make_folder("maps");
        is_drawn("maps/" + name, log, [&] {
            const MapSource source = source_of(input, e, runs.events[e], result, window, troubles);
            const MapLayer layer =
                read_map_layer(directory.path(name + ".tif"), base.spec.output.classes, source.style.words);
            LayerDrawer drawer(source);
            if (base.spec.output.report) {
                directory.make_folder(k_page_folder);
                drawer.draw_for_page_too(directory.path(k_page_folder));
            }
            drawer.draw(layer, false, directory.path("maps/" + name));
        });
    }
}

namespace {

std::string range(double low, double high, const Words& words) {
    const ReportNumbers number(words);
    return words("{1} to {2}", {number(low, 3), number(high, 3)});
}

/// A key's name, with its event if others have it not.
std::string name_of(const StudySpec& calibration, const KeySample& key, const std::string& name, const Words& words) {
    return key.event.empty() || calibration.events.size() == 1 ? name : words("{1} of {2}", {name, key.event});
}

Table keys_table(const StudyInput& input, const CalibrationResult& result, const Words& words) {
    const ReportNumbers number(words);
    Table table({words("Key"), words("distribution before"), words("best"), words("median"), words("90 % after"),
                 words("width, of that before")});
    for (std::size_t k = 0; k < result.keys.size(); ++k) {
        const KeySample& key = result.keys[k];
        const KeyPosterior& after = result.posteriors[k];
        const std::string name = name_of(input.spec(), key, key.key, words);
        std::string probabilities;
        for (const auto& [value, probability] : after.values)
            probabilities += (probabilities.empty() ? "" : ", ") + words.labelled(value, number(probability, 2));
        if (after.nominal)
            table.row({name, key.prior.text, key.texts[result.best], "", probabilities, ""});
        else
            table.row({name, key.prior.text, number(key.numbers[result.best], 4), number(after.median, 3),
                       range(after.low, after.high, words), number(after.width, 2)});
    }
    return table;
}

std::vector<Cell> scores_row(const std::string& event, const std::string& kind, const Explained& one,
                             const Words& words) {
    if (!one.possible) return {event, kind, words("no member finished"), "", "", ""};
    const ReportNumbers number(words);
    return {event,
            kind,
            number(one.best_score, 3),
            number(one.mean, 3),
            range(one.low, one.high, words),
            number(one.effective, 3)};
}

Table scores_table(const StudyInput& input, const CalibrationResult& result, const Words& words) {
    Table table({words("event"), words("values"), words("score of the best"), words("mean"), "5–95 %",
                 words("effective members")});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::string& event = input.spec().events[e].name;
        table.row(scores_row(event, words("fitted to all surveys"), result.events[e].fitted, words));
        if (input.events() > 1)
            table.row(scores_row(event, words("from the other surveys alone"), result.events[e].predicted, words));
    }
    return table;
}

Table misfits_table(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                    const Words& words) {
    const ReportNumbers number(words);
    Table table({words("event"), words("measure"), words("weight"), words("misfit of the best")});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.events[e];
        for (std::size_t m = 0; m < event.measures.size(); ++m) {
            const MeasureRow& measure = row_of(event.measures[m].measure);
            table.row({input.spec().events[e].name, measure.name, number(event.measures[m].weight),
                       number(event.agreements[result.best].parts[m], 3)});
        }
    }
    return table;
}

Table failures_table(const StudyInput& input, const CalibrationRuns& runs, const Words& words) {
    Table table({words("member"), words("event"), words("reason")});
    for (std::size_t e = 0; e < input.events(); ++e)
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (const std::string& why = runs.events[e].members[i].failure; !why.empty())
                table.row({std::to_string(i), input.spec().events[e].name, why});
    return table;
}

Table facts_table(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                  const Words& words) {
    const ReportNumbers number(words);
    std::vector<std::string> cells;
    for (const StudyInput& event : input.own) cells.push_back(number(event.base.scene.grid.cell_size));
    Table table;
    table.row({words("Runs"), words("{1}, of which {2} spread over the distributions",
                                    {std::to_string(runs.size()), std::to_string(runs.design)})});
    table.row({words("Effective number"), number(result.effective, 3)});
    table.row({with_unit(words("Cell size"), "m"), joined(cells, ", ")});
    if (const std::size_t failed = failed_of(runs.runs()); failed > 0)
        table.row({words("Failed runs"), std::to_string(failed)}, "warning");
    table.row({words("Last moves of the intervals [%]"),
               number(100 * runs.moves[0], 2) + ", " + number(100 * runs.moves[1], 2)});
    for (const Sentence& pair : result.sentences) table.row({words("Not told apart"), pair.in(words)});
    for (std::size_t e = 0; e < input.events(); ++e)
        if (const auto& check = result.scheme_checks[e])
            for (const auto& [name, value] : rows_of(*check))
                table.row({worded("{1}: {2}", {input.spec().events[e].name, name}).in(words), value.in(words)});
    table.row({words("Limitations"), words("These events and this model; a fit, not a forecast")});
    return table;
}

Document answer(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                const StudyFacts& facts, const Words& words) {
    Document answer;
    if (facts.troubles.are_first()) answer.add(Paragraph{{}, headline(facts.troubles).in(words), "warning"});
    return answer.heading("answer", words("Answer"))
        .add(keys_table(input, result, words))
        .add(scores_table(input, result, words))
        .add(facts_table(input, runs, result, words))
        .first_warnings(facts.warnings, words);
}

/// What the likelihood of each event rests on.
Table likelihood_table(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                       const Words& words) {
    const ReportNumbers number(words);
    Table table({words("event"), words("pieces of information"), "Q2", words("factor of the stated errors"),
                 words("not counted")});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const bool is_stated = runs.events[e].pieces > 0;
        table.row(
            {input.spec().events[e].name,
             is_stated ? number(runs.events[e].pieces, 3) : words("{1} (assumed)", {number(input.spec().exponent, 3)}),
             number(result.q2[e], 2), is_stated ? number(result.widening[e], 2) : "",
             joined(result.uncounted[e], ", ")});
    }
    return table;
}

void add_inputs(const StudyInput& input, const Words& words, Document& page) {
    page.heading("inputs", words("Inputs"));
    for (std::size_t e = 0; e < input.events(); ++e) {
        if (input.events() > 1) page.subheading(input.spec().events[e].name);
        page.add(inputs_table(input.own[e].base, words));
    }
}

std::string calibration_title(const StudyInput& input) {
    std::string names;
    for (const EventSpec& event : input.spec().events) names += (names.empty() ? "" : ", ") + event.name;
    return names;
}

/// What the charts of a calibration show.
struct CalibrationData {
    const StudyInput& input;
    const CalibrationResult& result;
};

/// The distribution of a key's values before the calibration and after it.
render::ChartPanel posterior_panel(const CalibrationData& data, const KeySample& key, const Words& words) {
    constexpr int k_parts = 40;  // of the distribution before
    const Parameter* const parameter = find_parameter(scene_parameters(), key.key);
    const std::string title = name_of(data.input.spec(), key, title_in(key.key, words), words);
    render::ChartPanel panel{title,
                             with_unit(title, parameter == nullptr ? "" : parameter->unit),
                             with_unit(words("Probability"), ""),
                             {},
                             {0, 1}};
    panel.x = key.prior.law == Law::log_uniform || key.prior.law == Law::log_normal ? render::Scale::logarithmic
                                                                                    : render::Scale::linear;
    StudySpec alone;
    alone.vary.push_back({key.key, key.prior});
    Places places;
    for (int i = 0; i <= k_parts; ++i) places.push_back({std::clamp(i / double{k_parts}, 1e-6, 1 - 1e-6)});
    Problems none;
    const SampleTable prior = samples_at(alone, places, "", none);
    render::ChartSeries before{words("before"), {150, 150, 150}, {}};
    before.stroke = render::Stroke::dashed;
    for (std::size_t i = 0; i < places.size(); ++i) before.points.push_back({prior.numbers[i][0], places[i][0]});
    render::ChartSeries after{words("after"), render::k_chart_colours[0], {}, 2.6};
    for (const Point& point : exceedance_curve(key.numbers, data.result.weights_after))
        after.points.push_back({point.x, 1 - point.y});
    panel.series = {std::move(before), std::move(after)};
    return panel;
}

std::optional<render::Chart> posterior(const CalibrationData& data, const std::string& title, const MapSource& source) {
    constexpr std::size_t k_most_panels = 9;
    std::vector<const KeySample*> keys;
    for (const KeySample& key : data.result.after)
        if (!key.prior.is_nominal() && keys.size() < k_most_panels) keys.push_back(&key);
    if (keys.empty()) return std::nullopt;
    const Words& words = source.style.words;
    render::Chart chart =
        chart_sheet(source, title, words("probability that the value is smaller"), "posterior.csv", keys.size());
    for (const KeySample* key : keys) chart.panels.push_back(posterior_panel(data, *key, words));
    return chart;
}

constexpr ChartRow<CalibrationData> k_calibration_charts[] = {
    {{"posterior", worded("values before and after the calibration")}, posterior}};

}  // namespace

void draw_calibration_charts(const StudyInput& input, const CalibrationResult& result, const ResultDirectory& directory,
                             RunLog& log) {
    const SceneSpec& scene = input.own.front().base.spec;
    if (scene.output.maps.front() == "off" || !scene.output.charts) return;
    MapSource source;
    source.title = calibration_title(input);
    source.style = calibration_style(scene);
    directory.make_folder("charts");
    draw_chart_rows(k_calibration_charts, CalibrationData{input, result}, source, directory.folder(),
                    scene.output.report, log);
}

void write_calibration_report(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const StudyFacts& facts, const ResultDirectory& directory) {
    const Words words = words_of(input.own.front().base.spec);
    const std::vector<std::string> maps = pictures_in(directory.path("maps"));
    const std::string& folder = directory.folder();
    Document page = answer(input, runs, result, facts, words);
    page.end_answer().heading("maps", words("Maps"));
    if (maps.empty()) page.paragraph(words("There are no maps."));
    page.maps(maps, folder, words)
        .heading("scores", words("How well the events are explained"))
        .add(misfits_table(input, runs, result, words))
        .add(likelihood_table(input, runs, result, words))
        .charts(titles_of(k_calibration_charts), folder, words);
    add_inputs(input, words, page);
    end_page(input, words("{1}: calibration", {calibration_title(input)}), failures_table(input, runs, words), facts,
             Opening::answer, std::move(page), folder);
}

}  // namespace frana::app::study
