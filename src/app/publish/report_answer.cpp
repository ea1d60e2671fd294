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

/// A value of the scenario and where it comes from.
struct Told {
    std::string name, value, origin;
};

/// A quantity that varies from place to place, with its range and its source; none if it does not.
std::optional<Told> by_place(const ReportInput& input, const std::string& key, const Words& words) {
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
        const std::string file = is_raster ? source->name : spec.terrain.friction_zones.value_or("");
        return Told{
            title_in(key, words),
            value_with_unit(least == greatest ? shown(least) : shown(least) + " – " + shown(greatest), zone.unit),
            input.prepared.friction && gives_by_table(key) ? words(input.prepared.friction->choice().table.called)
                                                           : fs::path(file).filename().string()};
    }
    return std::nullopt;
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

std::vector<Told> values_told(const ReportInput& input, const Words& words) {
    const SceneSpec& spec = input.prepared.spec;
    const std::vector<Parameter>& parameters = scene_parameters();
    std::vector<Told> told;
    for (const std::string& name : told_keys(spec)) {
        const Parameter& key = *find_parameter(parameters, name);
        const std::string text = key.write(spec).value_or("");
        const bool is_default = spec.origin_of(name) == Origin::default_value;
        // A table gives one bed friction, which two keys may name.
        const bool is_other_name = input.prepared.friction && name == "material.friction-angle";
        if (const auto zones = by_place(input, name, words); zones && !is_other_name) told.push_back(*zones);
        // An assumed density is worth knowing; other defaults are in the table of the keys.
        if (text.empty() || (is_default && name != "material.density")) continue;
        std::string value = value_of(key, spec, words);
        if (name == "material.friction-angle")
            value += " (μ = " + words.number(number_text(*friction_coefficient_of(spec.material), 3)) + ")";
        told.push_back({title_in(name, words), value, origin_text(spec, name, words)});
    }
    return told;
}

std::string laws_told(const ReportInput& input, const Words& words) {
    std::vector<std::string> told;
    for (const Law* law : laws_of(input.prepared.spec)) told.push_back(words(law->sentence));
    return joined(told, ", ");
}

std::vector<std::string> preset_comments(const SceneSpec& spec) {
    if (!spec.material.preset) return {};
    // Its values are in the report, whether its file can still be read or not.
    const auto presets = attempt([] { return material_presets(materials_directory()); });
    for (const MaterialPreset& preset : presets)
        if (preset.name == *spec.material.preset) return preset.comments;
    return {};
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
    if (origin == Origin::preset) return words("preset") + " " + spec.material.preset.value_or("");
    return words(describe(origin));
}

namespace {

/// The release, the model, and each value of its laws with its origin; the source of a preset.
Table scenario_table(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const SceneSpec& spec = input.prepared.spec;
    const RunResult& r = input.result;
    Table table({words("Scenario"), words("Value"), words("Origin")});
    const auto row = [&](const std::string& name, const std::string& value, const std::string& origin = "") {
        table.row({name, value, origin});
    };
    if (!r.released.empty()) {
        double volume = 0, area = 0, thickest = 0;
        for (const ReleasedArea& one : r.released) {
            volume += one.volume;
            area += one.area;
        }
        r.raster("release").values.for_each_stored(
            [&](std::size_t, double value) { thickest = std::max(thickest, value); });
        row(words("Release volume") + names_of_areas(r.released), number.grouped(volume) + " m³");
        row(words("Release area"), number.grouped(area) + " m²");
        row(words("Release thickness") + ", " + words("mean") + "; " + words("maximum"),
            number(area > 0 ? volume / area : 0, 3) + "; " + number(thickest, 3) + " m (" + words(k_vertical) + ")");
    }
    if (r.volume_inflow > 0) row(words("Inflow"), number.grouped(r.volume_inflow) + " m³");
    if (r.volume_rained > 0) row(words("Rain"), number.grouped(r.volume_rained) + " m³");
    if (r.exchanges) {
        row(words("Eroded from the bed"), number.grouped(r.volume_eroded) + " m³");
        row(words("Deposited on the bed"), number.grouped(r.volume_deposited) + " m³");
    }
    const bool is_structured = spec.material.model == "structured";
    row(is_structured ? words("Structured model") : voellmy_bingham_words(word_of(spec.numerics.scheme, k_schemes)),
        laws_told(input, words));
    for (const Told& one : values_told(input, words)) row(one.name, one.value, one.origin);
    if (const std::string source = preset_source(spec, words); !source.empty())
        row(words.labelled(words("Source"), *spec.material.preset), source);
    return table;
}

double greatest(const PeakValues& high) {
    return std::isnan(high.greatest) ? 0 : high.greatest;
}

/// The centre of the cell with the greatest value; none of a raster without values.
std::optional<Point> greatest_place(const Raster& raster) {
    std::optional<std::size_t> found;
    raster.values.for_each_stored([&](std::size_t cell, double value) {
        if (!std::isnan(value) && (!found || value > raster.values[*found])) found = cell;
    });
    if (!found) return std::nullopt;
    const auto cell = static_cast<std::int64_t>(*found);
    return raster.grid.cell_centre(cell / raster.grid.columns, cell % raster.grid.columns);
}

Cell error_cell(const ErrorEstimates& errors, const std::string& key, const Words& words) {
    return {error_text(errors, key, words), "soft"};
}

constexpr std::size_t k_answered = 2;  // of k_peak_statistics, that the four answers have

/// One of the four answers.
struct Answer {
    std::string question, figure, value, unit, error, where;
};

/// How far, how deep, how fast, how sure.
std::vector<Answer> answers(const ReportInput& input) {
    const Words& words = input.words;
    const ReportNumbers number(words);
    const SummaryFacts& f = input.facts;
    const RunResult& r = input.result;
    const auto place = [&](const std::optional<Point>& p) {
        return p ? words("E {1}, N {2}", {number.grouped(p->x), number.grouped(p->y)}) : std::string();
    };
    const Runout& run_out = f.statistics.run_out();
    std::vector<Answer> found{{words("How far"), words("Run-out"), number.grouped(run_out.horizontal_m), "m",
                               error_text(input.errors, k_run_out_key, words),
                               run_out.horizontal_m > 0 ? place(run_out.tip) : std::string()}};
    const auto strength = [&](std::size_t i, const std::string& question, const std::string& title) {
        const PeakStatistic& what = k_peak_statistics[i];
        const bool has_area = !std::isnan(f.high[i].p999);
        const double value = has_area ? f.high[i].p999 : greatest(f.high[i]);
        const std::string direction =
            i == 0 ? std::string(", ") + words(r.depth_is_normal ? k_normal : k_vertical) : "";
        const std::string key = std::string(what.name) + "_p999_" + what.key_unit;
        found.push_back({question, has_area ? title : words(what.title), number(value, 3), what.row().unit + direction,
                         has_area ? error_text(input.errors, key, words) : "",
                         place(greatest_place(r.raster(what.name)))});
    };
    strength(0, words("How deep"), words("99.9th percentile of depth"));
    strength(1, words("How fast"), words("99.9th percentile of speed"));
    const bool has_energy = r.energy_error.has_value();
    found.push_back({words("How sure"), has_energy ? words("energy error") : words("volume error"),
                     number(100 * (has_energy ? *r.energy_error : std::abs(relative_volume_error(r))), 2), "%",
                     input.errors.of.empty() ? words("no estimate") : "±",
                     words("cells of {1} m", {number(r.raster(RasterName::max_depth).grid.cell_size)})});
    return found;
}

Table four_answers(const ReportInput& input) {
    Table table({"", "", input.words("Value"), "", input.words("± by cell size"), input.words("Where")});
    for (const Answer& one : answers(input))
        table.row({one.question, one.figure, {one.value, "n"}, {one.unit, "u"}, {one.error, "soft"}, one.where});
    return table;
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

std::string error_text(const ErrorEstimates& errors, const std::string& key, const Words& words) {
    const auto estimate = errors.find(key);
    if (!estimate) return words("no estimate");
    const double error = estimate->error;
    if (!std::isfinite(error)) return words("not converging");
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
        {words("Volume"), number.grouped(r.volume_entered), "m³", ""},
        {words("Drop"), number.grouped(run_out.drop_m), "m", ""},
        {words("Angle of reach"), number(run_out.reach_angle_deg, 3), "°", ""},
        {words("Run-out along the flow path"), number.grouped(run_out.path_m),
         "m, " + number(run_out.path_m > 0 ? run_out.path_angle_deg() : 0, 3) + "°", ""},
        {words("Area deeper than {1} m", {number(f.statistics.threshold)}),
         number.grouped(f.statistics.covered_area_m2), "m²", "covered_area_m2"},
    };
    if (run_out.beta_deg > 0)
        where.insert(where.end() - 1,
                     {"α (Lied, Bakkehøi 1980), β = " + number(run_out.beta_deg, 3) + "°",
                      number(run_out.alpha_deg(), 3) + " ± " + number(Runout::k_alpha_deviation), "°", ""});
    std::vector<Row> strength;
    for (std::size_t i = 0; i < f.high.size(); ++i) {
        const PeakStatistic& what = k_peak_statistics[i];
        const std::string unit = std::string("_") + what.key_unit;
        strength.push_back({words(what.title), number(greatest(f.high[i]), 3), what.row().unit, what.name + unit});
        if (i >= k_answered && !std::isnan(f.high[i].p999))
            strength.push_back({words(what.title) + ", " + words("{1} % of the area", {number(99.9)}),
                                number(f.high[i].p999, 3), what.row().unit, std::string(what.name) + "_p999" + unit});
    }
    return Document().columns(Document()
                                  .add(values_table(words("Run-out and area"), where, input))
                                  .add(values_table(words("High values"), strength, input)));
}

std::string what_one_run_is(const SceneSpec& spec) {
    bool is_own = false;
    for (const std::string& key : told_keys(spec))
        is_own = is_own || (key != "material.density" && spec.origin_of(key) == Origin::scene_file);
    return is_own && !spec.friction_table.name ? worded("One run with one set of values, the scene's own.")
                                               : worded("One run with one set of values, uncalibrated.");
}

Document answer(const ReportInput& input) {
    return Document()
        .heading("answer", input.words("Answer"))
        .add(four_answers(input))
        .small(input.words(what_one_run_is(input.prepared.spec)));
}

std::string answer_lines(const ReportInput& input) {
    std::string lines;
    for (const Answer& one : answers(input)) {
        std::vector<std::string> parts{one.question + ": " + one.figure + ' ' + one.value + ' ' + one.unit};
        if (!one.error.empty() && one.error != "±")  // the row of a page says so of those above it
            parts.push_back(one.error.starts_with("±")
                                ? one.error
                                : input.words.labelled(input.words("± by cell size"), one.error));
        if (!one.where.empty()) parts.push_back(one.where);
        lines += (lines.empty() ? "" : "\n  ") + joined(parts, "; ");
    }
    return lines + "\n  " + input.words(what_one_run_is(input.prepared.spec));
}

Document scenario(const ReportInput& input) {
    const Words& words = input.words;
    return Document()
        .add(scenario_table(input))
        .add(exposure_answer(input.facts.exposure, ReachedBy::the_flow, words))
        .add(comparison_answer(input.comparison, words))
        .first_warnings(input.facts.warnings, words);
}

}  // namespace frana::app
