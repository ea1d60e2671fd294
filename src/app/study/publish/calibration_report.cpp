// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_calibration.h"

#include <algorithm>

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
#include "app/study/statistics/study_maps.h"
#include "app/text/number_text.h"
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

/// The runs of draws of an event's posterior: those that finished, and all.
StudyRuns drawn_runs(const EventRuns& event) {
    StudyRuns runs;
    const RecordFiles records(event.records);
    for (std::size_t i = event.searched; i < event.members.size(); ++i) {
        const bool has_failed = !event.members[i].failure.empty();
        if (!has_failed) runs.finished_at.push_back(runs.all.size());
        if (!has_failed) runs.finished.records.push_back(records.place(i));
        runs.all.records.push_back(records.place(i));
        runs.is_open.push_back(event.members[i].end.is_open() || has_failed);
    }
    for (FinishedMembers* one : {&runs.finished, &runs.all})
        one->weights.assign(one->size(), 1 / static_cast<double>(one->size()));
    return runs;
}

MapSource source_of(const StudyInput& input, std::size_t e, const EventRuns& runs, std::size_t best,
                    const CellWindow& window, const Troubles& troubles) {
    const Prepared& base = input.own[e].base;
    const double threshold = observed_threshold(base.spec);
    MapSource source;
    source.style = calibration_style(base.spec);
    const Words& words = source.style.words;
    source.title = base.spec.output.title.value_or(input.spec().events[e].name);
    const auto number = [&](double value) { return words.number(number_text(value, 3)); };
    source.subtitle = words("If it happens again: {1} runs that agree with the survey",
                            {std::to_string(runs.members.size() - runs.searched)});
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
        const Feature outline = release_outline(base.scene.release[i], i);
        source.release.insert(source.release.end(), outline.shape.areas.begin(), outline.shape.areas.end());
    }
    source.scar = surveyed(base).survey.scar;
    if (const auto run = read_record(RecordFiles(runs.records).place(best)))
        source.marks.push_back({words("Best run"),
                                gis::polygonise(trace_mask(run->raster(Quantity::depth, grid), threshold)),
                                k_best_colour, 1.8, true});
    return source;
}

}  // namespace

void publish_calibration_maps(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const Troubles& troubles, const ResultDirectory& directory, Findings found) {
    for (std::size_t e = 0; e < input.events(); ++e) {
        const Prepared& base = input.own[e].base;
        const StudyRuns drawn = drawn_runs(runs.events[e]);
        const CellWindow window = window_of(drawn.finished, base.scene.grid);
        if (window.rows == 0 || window.columns == 0) continue;
        const std::string name = "posterior_" + input.spec().events[e].name;
        MapWriter(base, directory)
            .write_probabilities(drawn, part_of(base.scene.grid, window),
                                 {Quantity::depth, {observed_threshold(base.spec)}, {name}});
        if (base.spec.output.maps.front() == "off") continue;
        directory.make_folder("maps");
        is_drawn("maps/" + name, found, [&] {
            const MapSource source = source_of(input, e, runs.events[e], result.events[e].best, window, troubles);
            const MapLayer layer = read_map_layer(directory.path(name + ".tif"), source.style.words);
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

Table keys_table(const StudyInput& input, const CalibrationResult& result, const Words& words) {
    const ReportNumbers number(words);
    Table table({words("event"), words("Key"), words("distribution before"), words("best"), words("median"),
                 words("90 % after"), words("width, of that before")});
    const auto add = [&](const KeyDraws& draws, const std::string& name, std::size_t e) {
        for (std::size_t k = 0; k < draws.keys.size(); ++k) {
            const Variation& key = draws.keys[k];
            const KeyPosterior& after = draws.posteriors[k];
            std::string probabilities, best;
            if (!draws.event.empty()) {
                const SampleTable& members = input.own[e].table;
                const std::size_t member = result.events[e].best;
                best = after.nominal ? members.values[member][k] : number(members.numbers[member][k], 4);
            }
            for (const auto& [value, probability] : after.values)
                probabilities += (probabilities.empty() ? "" : ", ") + words.labelled(value, number(probability, 2));
            if (after.nominal)
                table.row({name, key.key, key.distribution.text, best, "", probabilities, ""});
            else
                table.row({name, key.key, key.distribution.text, best, number(after.median, 3),
                           range(after.low, after.high, words), number(after.width, 2)});
        }
    };
    for (std::size_t e = 0; e < input.events(); ++e) add(result.events[e].after, input.spec().events[e].name, e);
    add(result.next, words("a new slope"), 0);
    return table;
}

std::vector<Cell> scores_row(const std::string& event, const std::string& kind, const std::string& best,
                             const Scores& one, const Words& words) {
    const ReportNumbers number(words);
    return {event, kind, best, number(one.mean, 3) + " ± " + number(k_normal * one.error, 1),
            range(one.low, one.high, words)};
}

Table scores_table(const StudyInput& input, const CalibrationResult& result, const Words& words) {
    Table table({words("event"), words("values"), words("best"), words("mean"), "5–95 %"});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::string& name = input.spec().events[e].name;
        const EventResult& event = result.events[e];
        table.row(scores_row(name, words("if it happens again"), ReportNumbers(words)(event.best_score, 3),
                             event.fitted, words));
        if (event.predicted)
            table.row(scores_row(name, words("from the other surveys alone"), "", *event.predicted, words));
    }
    return table;
}

Table misfits_table(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                    const Words& words) {
    const ReportNumbers number(words);
    Table table({words("event"), words("measure"), words("weight"), words("best")});
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.events[e];
        for (std::size_t m = 0; m < event.measures.size(); ++m) {
            const MeasureRow& measure = row_of(event.measures[m].measure);
            table.row({input.spec().events[e].name, measure.name, number(event.measures[m].weight),
                       number(event.agreements[result.events[e].best].parts[m], 3)});
        }
    }
    return table;
}

Table failures_table(const StudyInput& input, const CalibrationRuns& runs, const Words& words) {
    Table table({words("member"), words("event"), words("reason")});
    for (std::size_t e = 0; e < input.events(); ++e)
        for (std::size_t i = 0; i < runs.events[e].members.size(); ++i)
            if (const std::string& why = runs.events[e].members[i].failure; !why.empty())
                table.row({std::to_string(i), input.spec().events[e].name, why});
    return table;
}

Table facts_table(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                  const Words& words) {
    const ReportNumbers number(words);
    std::vector<std::string> cells, moves;
    std::size_t searched = 0, design = 0;
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventRuns& event = runs.events[e];
        cells.push_back(number(input.own[e].base.scene.grid.cell_size));
        const auto move = [&](double fraction) { return std::isnan(fraction) ? "–" : number(100 * fraction, 2); };
        moves.push_back(move(event.moves[0]) + ", " + move(event.moves[1]));
        searched += event.searched;
        design += event.design;
    }
    Table table;
    table.row({words("Runs"), words("{1}, of which {2} spread over the distributions",
                                    {std::to_string(searched), std::to_string(design)})});
    table.row({with_unit(words("Cell size"), "m"), joined(cells, ", ")});
    if (const std::size_t failed = failed_of(runs.runs()); failed > 0)
        table.row({words("Failed runs"), std::to_string(failed)}, "warning");
    table.row({words("Last moves of the intervals [%]"), joined(moves, "; ")});
    if (result.spread) table.row({words("Spread between slopes"), result.spread->in(words)});
    for (const EventResult& event : result.events) {
        for (const Sentence& pair : sentences(event.after.posteriors, event.after.indistinct))
            table.row({words("Indistinguishable keys"), pair.in(words)});
        if (event.scheme_check)
            for (const auto& [name, value] : rows_of(*event.scheme_check))
                table.row({worded("{1}: {2}", {event.after.event, name}).in(words), value.in(words)});
    }
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

/// The distribution of a key's values before the calibration, and after it for each event and another slope.
render::ChartPanel posterior_panel(const CalibrationData& data, const Variation& key, const Words& words) {
    constexpr int k_parts = 40;  // of the distribution before
    const Parameter* const parameter = find_parameter(scene_parameters(), key.key);
    const std::string title = title_in(key.key, words);
    render::ChartPanel panel{title,
                             with_unit(title, parameter == nullptr ? "" : parameter->unit),
                             with_unit(words("Probability"), ""),
                             {},
                             {0, 1}};
    panel.x = key.distribution.law == Law::log_uniform || key.distribution.law == Law::log_normal
                  ? render::Scale::logarithmic
                  : render::Scale::linear;
    StudySpec alone;
    alone.vary.push_back(key);
    Places places;
    for (int i = 0; i <= k_parts; ++i) places.push_back({std::clamp(i / double{k_parts}, 1e-6, 1 - 1e-6)});
    Problems none;
    const SampleTable prior = samples_at(alone, places, "", none);
    render::ChartSeries before{words("before"), {150, 150, 150}, {}};
    before.stroke = render::Stroke::dashed;
    for (std::size_t i = 0; i < places.size(); ++i) before.points.push_back({prior.numbers[i][0], places[i][0]});
    panel.series.push_back(std::move(before));
    const auto add = [&](const KeyDraws& draws, const std::string& name, double width) {
        for (std::size_t k = 0; k < draws.keys.size(); ++k) {
            if (draws.keys[k].key != key.key) continue;
            const std::size_t colour = (panel.series.size() - 1) % std::size(render::k_chart_colours);
            render::ChartSeries after{name, render::k_chart_colours[colour], {}, width};
            for (const Point& point : exceedance_curve(column_of(draws.sample.numbers, k), draws.weights))
                after.points.push_back({point.x, 1 - point.y});
            panel.series.push_back(std::move(after));
        }
    };
    for (const EventResult& event : data.result.events) add(event.after, event.after.event, 1.6);
    add(data.result.next, words("a new slope"), 2.6);
    return panel;
}

std::optional<render::Chart> posterior(const CalibrationData& data, const std::string& title, const MapSource& source) {
    constexpr std::size_t k_most_panels = 9;
    std::vector<Variation> keys = keys_of(data.input.spec());
    std::erase_if(keys, [](const Variation& key) { return key.distribution.is_nominal(); });
    keys.resize(std::min(keys.size(), k_most_panels));
    if (keys.empty()) return std::nullopt;
    const Words& words = source.style.words;
    render::Chart chart =
        chart_sheet(source, title, words("probability that the value is smaller"), "posterior.csv", keys.size());
    for (const Variation& key : keys) chart.panels.push_back(posterior_panel(data, key, words));
    return chart;
}

constexpr ChartRow<CalibrationData> k_calibration_charts[] = {
    {{"posterior", worded("values before and after the calibration")}, posterior}};

}  // namespace

void draw_calibration_charts(const StudyInput& input, const CalibrationResult& result, const ResultDirectory& directory,
                             Findings found) {
    const SceneSpec& scene = input.own.front().base.spec;
    if (scene.output.maps.front() == "off" || !scene.output.charts) return;
    MapSource source;
    source.title = calibration_title(input);
    source.style = calibration_style(scene);
    directory.make_folder("charts");
    draw_chart_rows(k_calibration_charts, CalibrationData{input, result}, source, directory.folder(),
                    scene.output.report, found);
}

void write_calibration_report(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const StudyFacts& facts, const ResultDirectory& directory) {
    const Words words = words_of(input.own.front().base.spec);
    const std::vector<std::string> maps = pictures_in(directory.path("maps"));
    const std::string& folder = directory.folder();
    Document page = answer(input, runs, result, facts, words);
    page.end_answer();
    if (!maps.empty()) page.heading("maps", words("Maps")).maps(maps, folder, words);
    page.heading("scores", words("How well the events are explained"))
        .add(misfits_table(input, runs, result, words))
        .charts(titles_of(k_calibration_charts), folder, words);
    add_inputs(input, words, page);
    end_page(input, words("{1}: calibration", {calibration_title(input)}), failures_table(input, runs, words), facts,
             Opening::answer, std::move(page), folder);
}

}  // namespace frana::app::study
