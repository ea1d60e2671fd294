// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_scenario.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <string_view>

#include "app/input/share_directory.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/markup.h"
#include "core/utf8.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/materials.h"
#include "params/keys/model_keys.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/zone_keys.h"
#include "params/scene/write_scene.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_names = 3, k_area_letters = 40;

/// Names of the keys of laws; of the structured model, those that a reader asks for first.
struct KeyName {
    const char *key, *name;
};
constexpr KeyName k_names_of_keys[] = {
    {"material.friction-angle", worded("friction angle")},
    {"material.friction-coefficient", worded("friction coefficient")},
    {"material.turbulence", worded("turbulence")},
    {"material.density", worded("density")},
    {"material.viscosity", worded("viscosity")},
    {"material.yield-stress", worded("yield stress")},
    {"material.cohesion", worded("cohesion")},
    {"material.pore-pressure-ratio", worded("pore pressure ratio")},
    {"material.consistency", worded("consistency")},
    {"material.flow-index", worded("flow index")},
    {"material.laminar-resistance", worded("laminar resistance")},
    {"material.manning", "Manning n"},
    {"material.chezy", "Chezy C"},
    {"material.internal-friction-angle", worded("internal friction angle")},
    {"entrainment.erodible-depth", worded("erodible depth")},
    {"structured.internal-friction-angle", worded("internal friction angle")},
    {"structured.bed-friction-angle", worded("friction angle at the bed")},
    {"structured.cohesion", worded("cohesion")},
    {"structured.solid-fraction", worded("fraction of solids")},
    {"structured.grain-density", worded("density of the grains")},
    {"structured.fluid-density", worded("density of the fluid")},
    {"structured.manning", "Manning n"},
};

std::string name_of(const std::string& key, const Words& words) {
    for (const KeyName& one : k_names_of_keys)
        if (key == one.key) return words(one.name);
    std::string name = key.substr(key.find('.') + 1);
    std::replace(name.begin(), name.end(), '-', ' ');
    return name;
}

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
        const std::string file = is_raster ? source->name : spec.terrain.friction_zones.value_or("");
        return words(
            "{1} {2} by place (zones of {3})",
            {name_of(key, words),
             value_with_unit(least == greatest ? shown(least) : shown(least) + " – " + shown(greatest), zone.unit),
             fs::path(file).filename().string()});
    }
    return "";
}

/// The keys whose values say what the material is, in the order of the table of laws.
std::vector<std::string> told_keys(const SceneSpec& spec) {
    std::vector<std::string> keys;
    if (spec.material.model == "structured") {
        for (const KeyName& one : k_names_of_keys)
            if (std::string_view(one.key).starts_with("structured.") && model_reads(spec, one.key))
                keys.emplace_back(one.key);
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
        if (const std::string zones = by_place(input, name, words); !zones.empty()) told.push_back(zones);
        // An assumed density is worth knowing; other defaults are in the table of the keys.
        if (text.empty() || (is_default && name != "material.density")) continue;
        std::string value = name_of(name, words) + " " + value_of(key, spec, words);
        if (name == "material.friction-angle")
            value += " (μ = " + words.number(number_text(friction_coefficient(spec.material), 3)) + ")";
        told.push_back(value + " (" + origin_text(spec, name, words) + ")");
    }
    return told;
}

std::string laws_told(const ReportInput& input, const Words& words) {
    std::vector<std::string> told;
    for (const Law* law : laws_of(input.prepared.spec)) told.push_back(words(law->sentence));
    return joined(told, ", ");
}

/// Puts no line break between the groups of a number, and between a number and its unit.
std::string kept_together(const std::string& text) {
    static constexpr std::string_view k_begins = "0123456789msk%P";
    std::string together;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool in_value = text[i] == ' ' && i > 0 && i + 1 < text.size() && text[i - 1] >= '0' &&
                              text[i - 1] <= '9' && k_begins.find(text[i + 1]) != std::string_view::npos;
        together += in_value ? "\u00A0" : std::string(1, text[i]);
    }
    return together;
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

std::string paragraph(const std::string& lead, const std::string& text) {
    return "<p>" + (lead.empty() ? "" : "<b>" + escaped_markup(lead) + "</b> ") + escaped_markup(kept_together(text)) +
           "</p>\n";
}

std::string origin_text(const SceneSpec& spec, const std::string& key, const Words& words) {
    const Origin origin = spec.origin_of(key);
    if (origin == Origin::preset) return words("preset {1}", {spec.material.preset.value_or("")});
    return words(describe(origin));
}

std::vector<std::string> preset_comments(const SceneSpec& spec) {
    if (!spec.material.preset) return {};
    try {
        for (const MaterialPreset& preset : material_presets(materials_directory()))
            if (preset.name == *spec.material.preset) return preset.comments;
    } catch (const Error&) {
        // Its values are in the report, whether its file can still be read or not.
    }
    return {};
}

std::string release_sentences(const ReportInput& input) {
    const Words& words = input.words;
    const RunResult& r = input.result;
    double volume = 0, area = 0, thickest = 0;
    for (const ReleasedArea& one : r.released) {
        volume += one.volume;
        area += one.area;
    }
    r.release.values.for_each_stored([&](std::size_t, double value) { thickest = std::max(thickest, value); });
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
    return paragraph(words("What fails."), joined(told, " "));
}

std::string material_sentences(const ReportInput& input) {
    const Words& words = input.words;
    const SceneSpec& spec = input.prepared.spec;
    const std::string laws = laws_told(input, words);
    std::string text =
        spec.material.model == "structured" ? words("Structured two-phase model.") : words("Voellmy-Bingham model:");
    if (!laws.empty()) text += " " + laws + ".";
    const std::string values = joined(values_told(input, words), ", ");
    if (!values.empty()) text += " " + words("Values: {1}.", {values});
    std::string html = paragraph(words("Friction and material."), text);
    if (const std::string source = preset_source(spec, words); !source.empty())
        html += "<p class=\"small\">" + escaped_markup(words("Source of the preset {1}:", {*spec.material.preset})) +
                " " + escaped_markup(source) + "</p>\n";
    return html;
}

}  // namespace frana::app
