// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_answer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>

#include "analysis/ground_statistics.h"
#include "app/input/share_directory.h"
#include "app/pictures/result_numbers.h"
#include "app/publish/html_page.h"
#include "app/publish/report.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_tables.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/materials.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"
#include "params/keys/zone_keys.h"
#include "params/scene/write_scene.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_names = 3, k_area_letters = 40;

/// Of the structured model, the keys that a reader asks for first.
constexpr const char* k_structured_keys[] = {"structured.internal-friction-angle",
                                             "structured.bed-friction-angle",
                                             "structured.cohesion",
                                             "structured.solid-fraction",
                                             "structured.grain-density",
                                             "structured.fluid-density",
                                             "structured.manning"};

std::string value_with_unit(const std::string& value, const std::string& unit) {
    static const std::map<std::string, std::string> k_units{
        {"degrees", "°"}, {"m/s2", " m/s²"}, {"kg/m3", " kg/m³"}, {"m3", " m³"}};
    if (unit.empty()) return value;
    const auto found = k_units.find(unit);
    return value + (found == k_units.end() ? " " + unit : found->second);
}

/// A value as in the scene file; of a file only its name.
std::string value_of(const Parameter& key, const SceneSpec& spec, const Words& words) {
    const std::string text = key.write(spec).value_or("");
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) return fs::path(text.substr(colon + 1)).filename().string();
    return number_from_text(text) ? value_with_unit(words.number(text), key.unit) : text;
}

std::string names_of_areas(const std::vector<ReleasedArea>& areas) {
    std::vector<std::string> names;
    for (const ReleasedArea& area : areas)
        if (!area.name.empty()) names.push_back(elided(valid_utf8(area.name), k_area_letters));
    if (names.empty()) return "";
    const std::size_t all = names.size();
    names.resize(std::min(all, k_names));
    return " (" + joined(names, ", ") + (all > k_names ? ", … " + std::to_string(all - k_names) + ")" : ")");
}

/// A quantity that varies from place to place, with its range and its file; empty if it does not.
std::string by_place(const ReportInput& input, const std::string& key, const Words& words) {
    const SceneSpec& spec = input.prepared.spec;
    const std::string quantity = key.substr(key.find('.') + 1);
    for (const ZoneKey& zone : zone_keys()) {
        if (zone.name.substr(zone.name.find('.') + 1) != quantity) continue;
        const auto row = std::find_if(std::begin(k_zone_rasters), std::end(k_zone_rasters),
                                      [&](const ZoneRaster& one) { return one.what == zone.what; });
        if (row == std::end(k_zone_rasters) || !(input.prepared.scene.zones.*(row->raster))) continue;
        double least = std::numeric_limits<double>::infinity(), greatest = -least;
        (input.prepared.scene.zones.*(row->raster))->values.for_each_stored([&](std::size_t, double value) {
            if (!std::isfinite(value)) return;
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        });
        if (!(least <= greatest)) continue;
        const auto shown = [&](double value) {
            return words.number(number_text(zone.degrees() ? std::atan(value) * 180 / std::numbers::pi : value, 3));
        };
        const auto& source = spec.zones.*(zone.source);
        const bool is_raster = source && source->kind == SourceSpec::Kind::raster;
        const std::string value =
            value_with_unit(least == greatest ? shown(least) : shown(least) + " – " + shown(greatest), zone.unit);
        if (input.prepared.friction && gives_by_table(key))
            return words("{1} {2} by place, after {3}",
                         {title_in(key, words), value, words(input.prepared.friction->choice().table.called)});
        const std::string file = is_raster ? source->name : spec.terrain.friction_zones.value_or("");
        return words("{1} {2} by place (zones of {3})",
                     {title_in(key, words), value, fs::path(file).filename().string()});
    }
    return "";
}

/// The keys whose values say what the material is, in the order of the table of laws.
std::vector<std::string> told_keys(const SceneSpec& spec) {
    std::vector<std::string> keys;
    if (spec.material.model == "structured") {
        for (const char* const key : k_structured_keys)
            if (model_reads(spec, key)) keys.emplace_back(key);
        return keys;
    }
    const std::vector<const Law*> laws = laws_of(spec);
    for (const std::string& key : law_keys())
        if (!readers_of(key, laws).empty()) keys.push_back(key);
    keys.emplace_back("material.density");
    return keys;
}

std::vector<std::string> values_told(const ReportInput& input, const Words& words) {
    const SceneSpec& spec = input.prepared.spec;
    const std::vector<Parameter>& parameters = scene_parameters();
    std::vector<std::string> told;
    for (const std::string& name : told_keys(spec)) {
        const Parameter& key = *find_parameter(parameters, name);
        const std::string text = key.write(spec).value_or("");
        const bool is_default = spec.origin_of(name) == Origin::default_value;
        // A table gives one bed friction, which two keys may name.
        const bool is_other_name = input.prepared.friction && name == "material.friction-angle";
        if (const std::string zones = by_place(input, name, words); !zones.empty() && !is_other_name)
            told.push_back(zones);
        // An assumed density is worth knowing; other defaults are in the table of the keys.
        if (text.empty() || (is_default && name != "material.density")) continue;
        std::string value = title_in(name, words) + " " + value_of(key, spec, words);
        if (name == "material.friction-angle")
            value += " (μ = " + words.number(number_text(spec.material.bed_friction_coefficient(), 3)) + ")";
        told.push_back(value + " (" + origin_text(spec, name, words) + ")");
    }
    return told;
}

std::string laws_told(const ReportInput& input, const Words& words) {
    std::vector<std::string> told;
    for (const Law* law : laws_of(input.prepared.spec)) told.push_back(words(law->sentence));
    return joined(told, ", ");
}

/// Returns the preset's source without its label; of a user's own preset as that has it.
std::string preset_source(const SceneSpec& spec, const Words& words) {
    for (const std::string& text : paragraphs_of(preset_comments(spec))) {
        if (!text.starts_with("Source: ")) continue;
        const std::string shown = words(text), label_end = ": ";
        return shown.substr(shown.find(label_end) + label_end.size());
    }
    return "";
}

}  // namespace

std::string origin_text(const SceneSpec& spec, const std::string& key, const Words& words) {
    const Origin origin = spec.origin_of(key);
    if (origin == Origin::preset) return words("preset {1}", {spec.material.preset.value_or("")});
    return words(describe(origin));
}

std::vector<std::string> preset_comments(const SceneSpec& spec) {
    if (!spec.material.preset) return {};
    // Its values are in the report, whether its file can still be read or not.
    const auto presets = attempt([] { return material_presets(materials_directory()); });
    for (const MaterialPreset& preset : presets)
        if (preset.name == *spec.material.preset) return preset.comments;
    return {};
}

Document release_sentences(const ReportInput& input) {
    const Words& words = input.words;
    const RunResult& r = input.result;
    double volume = 0, area = 0, thickest = 0;
    for (const ReleasedArea& one : r.released) {
        volume += one.volume;
        area += one.area;
    }
    r.raster("release").values.for_each_stored(
        [&](std::size_t, double value) { thickest = std::max(thickest, value); });
    const auto grouped_number = [&](double value) { return words.number(grouped(value)); };
    std::vector<std::string> told;
    if (!r.released.empty()) {
        const std::string names = names_of_areas(r.released);
        const std::string count = std::to_string(r.released.size());
        told.push_back((r.released.size() == 1 ? words("One area fails{1}:", {names})
                                               : words("{1} areas fail{2}:", {count, names})) +
                       " " +
                       words("{1} m³ from {2} m² in map view, {3} m thick on average and {4} m at most, vertical.",
                             {grouped_number(volume), grouped_number(area),
                              words.number(number_text(area > 0 ? volume / area : 0, 3)),
                              words.number(number_text(thickest, 3))}));
    }
    if (r.volume_inflow > 0) told.push_back(words("{1} m³ flow in through lines.", {grouped_number(r.volume_inflow)}));
    if (r.exchanges)
        told.push_back(words("On its way the flow erodes {1} m³ and deposits {2} m³ on the bed.",
                             {grouped_number(r.volume_eroded), grouped_number(r.volume_deposited)}));
    return Document().paragraph(words("What fails."), joined(told, " "));
}

namespace {

/// Model, laws, and each value of theirs with its origin; the source of a preset.
Document material_sentences(const ReportInput& input) {
    const Words& words = input.words;
    const SceneSpec& spec = input.prepared.spec;
    const std::string laws = laws_told(input, words);
    std::string text =
        spec.material.model == "structured" ? words("Structured two-phase model.") : words("Voellmy-Bingham model:");
    if (!laws.empty()) text += " " + laws + ".";
    const std::string values = joined(values_told(input, words), ", ");
    if (!values.empty()) text += " " + words("Values: {1}.", {values});
    Document told;
    told.paragraph(words("Friction and material."), text);
    if (const std::string source = preset_source(spec, words); !source.empty())
        told.small(words("Source of the preset {1}:", {*spec.material.preset}) + " " + source);
    return told;
}

constexpr std::size_t k_gauges = 4, k_gauge_letters = 30;
constexpr const char* k_cell_error = "cell error";
const std::string k_error_of = "error of ";

double greatest(const PeakValues& high) {
    return std::isnan(high.greatest) ? 0 : high.greatest;
}

std::string arrivals(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const std::vector<GaugeAnswer> gauges = gauge_answers(input);
    std::vector<std::string> told;
    for (std::size_t i = 0; i < std::min(k_gauges, gauges.size()); ++i) {
        const std::string name = elided(valid_utf8(gauges[i].name), k_gauge_letters);
        told.push_back(gauges[i].arrival ? words("{1} after {2} s", {name, number(*gauges[i].arrival, 3)})
                                         : words("{1} is not reached", {name}));
    }
    if (told.empty()) return "";
    const std::string more = gauges.size() > k_gauges ? ", …" : "";
    return " " + words("First arrival at gauges: {1}.", {joined(told, ", ") + more});
}

/// The cell of the greatest depth: one cell of a cliff is no depth of the flow.
struct DeepestCell {
    Point place;
    double cosine = 1;  ///< of the slope of its bed
};

std::optional<DeepestCell> deepest_cell(const Raster& depth, const Raster& bed) {
    std::optional<std::size_t> deepest;
    depth.values.for_each_stored([&](std::size_t cell, double value) {
        if (!std::isnan(value) && (!deepest || value > depth.values[*deepest])) deepest = cell;
    });
    if (!deepest) return std::nullopt;
    const GridSpec& grid = depth.grid;
    const auto row = static_cast<std::int64_t>(*deepest) / grid.columns,
               column = static_cast<std::int64_t>(*deepest) % grid.columns;
    return DeepestCell{grid.cell_centre(row, column), bed_cosine(bed, row, column)};
}

/// What all but a thousandth of the area stays below; the greatest of a single cell in brackets.
std::string strength_sentence(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const auto& [depth, speed] = std::pair(input.facts.high[0], input.facts.high[1]);
    const auto cell = deepest_cell(input.result.raster("max_depth"), input.result.raster("bed"));
    if (!cell || std::isnan(depth.p999) || std::isnan(speed.p999))
        return words("The greatest depth is {1} m, the greatest speed {2} m/s.",
                     {number(greatest(depth), 3), number(greatest(speed), 3)});
    const auto when =
        std::max_element(input.result.series.begin(), input.result.series.end(),
                         [](const SeriesRow& a, const SeriesRow& b) { return a.max_depth < b.max_depth; });
    const bool is_normal = input.result.depth_is_normal;
    const double vertical = is_normal ? greatest(depth) / cell->cosine : greatest(depth),
                 slope_deg = std::acos(cell->cosine) * 180 / std::numbers::pi;
    const std::string depth_text = number(depth.p999, 3) + " m (" + words(is_normal ? k_normal : k_vertical) + ")";
    return words(
        "But for a thousandth of that area the flow is at most {1} deep and {2} m/s fast (one cell: {3} m vertical, "
        "{4} m normal to a bed of {5}°, after {6} s at E {7}, N {8}; one cell: {9} m/s).",
        {depth_text, number(speed.p999, 3), number(vertical, 3), number(vertical * cell->cosine, 3),
         number(slope_deg, 2), number(when->time, 3), number.grouped(cell->place.x), number.grouped(cell->place.y),
         number(greatest(speed), 3)});
}

Document where_sentences(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const SummaryFacts& f = input.facts;
    const Runout& run_out = f.statistics.run_out();
    std::string text = words(
        "Run-out {1} m: straight in map view, from the top of the release to the farthest place reached, {2} m "
        "lower: angle of reach {3}°.",
        {number.grouped(run_out.horizontal_m), number.grouped(run_out.drop_m), number(run_out.reach_angle_deg, 3)});
    if (run_out.path_m > 0)
        text += " " + words("Along the flow path it is {1} m, at {2}°.",
                            {number.grouped(run_out.path_m), number(run_out.path_angle_deg(), 3)});
    text += " " +
            words("{1} m² are deeper than {2} m at some time.",
                  {number.grouped(f.statistics.covered_area_m2), number(f.statistics.threshold)}) +
            " " + strength_sentence(input);
    if (const std::size_t flows = f.statistics.run_outs.size(); flows > 1)
        text += " " + words("{1} flows never met; the run-out is that of the longest.", {std::to_string(flows)});
    return Document().paragraph(words("Where it goes."), text + arrivals(input));
}

std::string cell_error_sentence(const ErrorEstimates& errors, double cell_size, const Words& words) {
    const std::string size = ReportNumbers(words)(cell_size);
    if (errors.of.empty())
        return words(
            "On cells of {1} m; there is no estimate of the error from their size (frana converge or "
            "numerics.accuracy gives one).",
            {size});
    return words("On cells of {1} m; the error from their size is estimated and stands beside the values (±).", {size});
}

std::string balance_sentence(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    constexpr double k_least = 1e-4;  // [%]; less is rounding
    const double error = 100 * std::abs(relative_volume_error(input.result));
    const std::string volume = error < k_least ? "< " + number(k_least) : number(error, 2);
    if (!input.result.energy_error) return words("The volume is conserved to {1} %.", {volume});
    return words("The volume is conserved to {1} %, the energy rises without cause by at most {2} %.",
                 {volume, number(100 * *input.result.energy_error, 2)});
}

std::string end_sentences(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const RunResult& r = input.result;
    const RunEnd end = run_end(r);
    std::string text = end_sentence(end, words);
    if (end.creeps) text += " " + creeping_sentence(end).in(words);
    if (end.is_cut_short)
        text += " " +
                words(r.settling && r.settling->front_is_final
                          ? worded("Material was still moving: final depth is not that of the deposit.")
                          : worded("Material was still moving: final depth and run-out are not those of the deposit."));
    if (input.facts.statistics.end && input.facts.statistics.end->is_held)
        text += " " + words("Cells without elevation held the flow back: its full run-out may not be shown.");
    if (r.volume_left > 0 && r.volume_entered > 0)
        text += " " + words("{1} m³ ({2} %) left the computed ground: the full run-out is not shown.",
                            {number.grouped(r.volume_left), number(100 * r.volume_left / r.volume_entered, 2)});
    if (r.jumps)
        text +=
            " " + words(
                      "{1} m³ flew over edges, in all jumps together, at most {2} m above the ground and {3} m far: "
                      "where all passes overhead, the maps of depth, speed and pressure show none.",
                      {number.grouped(r.jumps->volume), number(r.jumps->highest, 3), number(r.jumps->longest, 3)});
    if (!r.hard_events.none()) text += " " + words("There were numerical events that do not occur in a good run.");
    return text;
}

/// A key: of the estimate, by which it is replaced.
Cell error_cell(const ErrorEstimates& errors, const std::string& key, const Words& words) {
    return {error_text(errors, key, words), "soft", key.empty() ? "" : k_error_of + key};
}

/// A row of the answer's tables.
struct Row {
    std::string name, value, unit, key;  ///< key: of its estimate
};

Table values_table(const std::string& head, const std::vector<Row>& rows, const ReportInput& input) {
    Table table({head, "", "", input.words("± by cell size")});
    for (const Row& row : rows)
        table.number(row.name, row.value, row.unit, {error_cell(input.errors, row.key, input.words)});
    return table;
}

}  // namespace

std::vector<GaugeAnswer> gauge_answers(const ReportInput& input) {
    std::vector<GaugeAnswer> answers;
    for (const Gauge& gauge : input.prepared.scene.recording.gauges) answers.push_back({gauge.name, {}, 0, 0});
    const double least = input.prepared.scene.numerics.minimum_depth;
    for (const GaugeRow& row : input.result.gauges) {
        GaugeAnswer& one = answers[row.gauge];
        if (!one.arrival && row.depth > least) one.arrival = row.time;
        one.depth = std::max(one.depth, row.depth);
        one.speed = std::max(one.speed, row.speed);
    }
    return answers;
}

std::vector<PagePart> error_parts(const ErrorEstimates& errors, double cell_size, const Words& words) {
    std::vector<PagePart> parts{{k_cell_error, html_of(Span{cell_error_sentence(errors, cell_size, words)}) + "\n"}};
    for (const auto& [key, error] : errors.of)
        parts.push_back({k_error_of + key, html_of(error_cell(errors, key, words)), true});
    return parts;
}

std::string error_text(const ErrorEstimates& errors, const std::string& key, const Words& words) {
    const auto estimate = errors.find(key);
    if (!estimate) return words("no estimate");
    const double error = estimate->error;
    if (!std::isfinite(error)) return words("not converged");
    const std::string text = "± " + words.number(error < 1000 ? number_text(error, 2) : grouped(error));
    return estimate->converging ? text : text + ", " + words("not converging");
}

Document answer_tables(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const SummaryFacts& f = input.facts;
    const Runout& run_out = f.statistics.run_out();
    const RunResult& r = input.result;
    std::vector<Row> where{
        {words("Volume that came in"), number.grouped(r.volume_entered), "m³", ""},
        {words("Run-out, in map view"), number.grouped(run_out.horizontal_m), "m", k_run_out_key},
        {words("Drop"), number.grouped(run_out.drop_m), "m", ""},
        {words("Angle of reach"), number(run_out.reach_angle_deg, 3), "°", ""},
        {words("Run-out along the flow path"), number.grouped(run_out.path_m), "m", ""},
        {words("Angle along the flow path"), number(run_out.path_m > 0 ? run_out.path_angle_deg() : 0, 3), "°", ""},
        {words("Area deeper than {1} m", {number(f.statistics.threshold)}),
         number.grouped(f.statistics.covered_area_m2), "m²", "covered_area_m2"},
    };
    std::vector<Row> strength;
    for (std::size_t i = 0; i < f.high.size(); ++i) {
        const PeakStatistic& what = k_peak_statistics[i];
        const std::string unit = std::string("_") + what.key_unit;
        strength.push_back({words(what.title), number(greatest(f.high[i]), 3), what.row().unit, what.name + unit});
        if (!std::isnan(f.high[i].p999))
            strength.push_back({words("on 99.9 % of the area"), number(f.high[i].p999, 3), what.row().unit,
                                std::string(what.name) + "_p999" + unit});
    }
    return Document().columns(Document()
                                  .add(values_table(words("Where it goes"), where, input))
                                  .add(values_table(words("How strong, at most"), strength, input)));
}

Warnings warnings_of(const ReportInput& input) {
    Warnings warnings = input.facts.warnings;
    if (const auto& accuracy = input.facts.accuracy)
        std::replace(warnings.begin(), warnings.end(), Warning(accuracy_verdict(*accuracy)),
                     Warning(accuracy_verdict(*accuracy, input.words)));
    return warnings;
}

Document answer_sentences(const ReportInput& input) {
    const Words& words = input.words;
    return Document()
        .heading("answer", words("Scenario and answer"))
        .add(release_sentences(input))
        .add(material_sentences(input))
        .add(where_sentences(input))
        .add(exposure_answer(input.facts.exposure, ReachedBy::the_flow, words))
        .add(Paragraph{
            {{cell_error_sentence(input.errors, input.result.raster("max_depth").grid.cell_size, words), k_cell_error},
             {balance_sentence(input) + " " + end_sentences(input)}},
            words("How sure.")})
        .part(k_comparison_answer, comparison_answer(input.comparison, words))
        .first_warnings(warnings_of(input), words)
        .paragraph(words("Not done."),
                   words("This is one run with one set of values, not a range of what is possible: frana ensemble "
                         "computes the range, frana calibrate fits the values to observed events."));
}

}  // namespace frana::app
