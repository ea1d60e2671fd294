// SPDX-License-Identifier: Apache-2.0
#include "params/keys/used_keys.h"

#include <algorithm>
#include <string_view>

#include "core/words/words.h"
#include "params/keys/laws.h"

namespace frana {
namespace {

constexpr std::string_view k_main_keys[] = {
    "terrain.dtm",
    "terrain.crs",
    "terrain.cell-size",
    "terrain.vertical-unit",
    "terrain.nodata-policy",
    "release.perimeter",
    "release.thickness",
    "release.thickness-direction",
    "release.dtm-contains-release",
    "material.preset",
    "material.friction-angle",
    "material.turbulence",
    "material.density",
    "numerics.accuracy",
    "time.end",
    "time.frame-interval",
    "output.title",
    "output.trace-threshold",
    "hazard.scheme",
    "observed.perimeter",
};

/// A key whose own words do not say what it is to somebody who does not know scene files.
struct KeyTitle {
    const char *key, *title;
};

constexpr std::size_t k_first_keys = 10;  ///< of these rows, in this order
constexpr KeyTitle k_titles[] = {
    {"terrain.dtm", "terrain model (DTM)"},
    {"release.perimeter", "release area"},
    {"release.thickness", "release thickness"},
    {"material.preset", "process and material preset"},
    {"time.end", "longest simulated time"},
    {"terrain.cell-size", "cell size"},
    {"numerics.accuracy", "accuracy, instead of a cell size"},
    {"output.maps", "maps"},
    {"output.language", "language of maps and report"},
    {"observed.perimeter", "surveyed outline"},
    {"terrain.crs", "working CRS"},
    {"terrain.dtm-crs", "CRS of the DTM"},
    {"terrain.bounds", "part of the DTM"},
    {"terrain.nodata-policy", "ground without elevation"},
    {"terrain.nodata-value", "value that means no elevation"},
    {"terrain.error", "error of the elevations"},
    {"terrain.source", "source of the elevations"},
    {"release.dtm-contains-release", "DTM contains the release"},
    {"release.start", "time of failure"},
    {"release.velocity", "initial speed"},
    {"inflow.line", "lines of inflow"},
    {"material.bed-friction", "laws of bed friction"},
    {"structured.fluid-density", "density of the fluid"},
    {"structured.manning", "Manning n"},
    {"structured.solid-fraction", "fraction of solids"},
    {"structured.grain-density", "density of the grains"},
    {"structured.bed-friction-angle", "friction angle at the bed"},
    {"structured.zones", "areas of these values"},
    {"numerics.cfl", "Courant number"},
    {"output.names", "names of the files"},
    {"observed.front", "surveyed front"},
    {"observed.deposit", "surveyed deposit"},
    {"observed.threshold", "depth that counts as covered"},
};

}  // namespace

bool is_main_key(const std::string& name) {
    return std::find(std::begin(k_main_keys), std::end(k_main_keys), name) != std::end(k_main_keys);
}

std::optional<std::size_t> place_in_dialogue(const std::string& name) {
    for (std::size_t place = 0; place < k_first_keys; ++place)
        if (name == k_titles[place].key) return place;
    return std::nullopt;
}

std::string title_of(const Parameter& key) {
    for (const KeyTitle& row : k_titles)
        if (key.name() == row.key) return row.title;
    if (!key.called.empty()) return key.called;
    std::string title = key.key;
    std::replace(title.begin(), title.end(), '-', ' ');
    return title;
}

namespace {

const std::string k_required_with = "required with ";

/// The meaning without the laws that use the key.
std::string own_meaning(const Parameter& key) {
    const std::string laws = used_by(key.name());
    return key.meaning.ends_with(laws) ? key.meaning.substr(0, key.meaning.size() - laws.size()) : key.meaning;
}

/// "material.bed-friction = bingham or manning": keys and their values, with the conjunction between them.
std::string choices_in(std::string keys, const Words& words) {
    const std::string or_word = " or ";
    for (std::size_t at = 0; (at = keys.find(or_word, at)) != std::string::npos;) {
        const std::string shown = " " + words("or") + " ";
        keys.replace(at, or_word.size(), shown);
        at += shown.size();
    }
    return keys;
}

}  // namespace

std::string used_by(const std::string& key) {
    const std::vector<const Law*> readers = readers_of(key);
    return readers.empty() ? "" : " Used by " + selected_by(readers) + ".";
}

std::string meaning_in(const Parameter& key, const Words& words) {
    const std::string own = own_meaning(key);
    if (own == key.meaning) return words(own);
    return words(own) + " " + words("Used by {1}.", {choices_in(selected_by(readers_of(key.name())), words)});
}

std::string absent_in(const Parameter& key, const Words& words) {
    if (!key.absent.starts_with(k_required_with)) return NumberPattern(key.absent).in(words);
    const std::string what = key.absent.substr(k_required_with.size());
    return words("required with {1}", {what == "solids" ? words("solids") : choices_in(what, words)});
}

std::vector<std::string> rows_of(const Parameter& key) {
    std::vector<std::string> rows{own_meaning(key), title_of(key)};
    const std::string absent = NumberPattern(key.absent).text;
    const bool is_key = absent.find('.') != absent.npos && absent.find(' ') == absent.npos;  // another key's value
    const bool has_words = !absent.empty() && absent != "{1}" && absent != "off" && !is_key;
    if (has_words && !absent.starts_with(k_required_with)) rows.push_back(absent);
    return rows;
}

namespace {

/// A key with a default that is read only if another key asks for it.
struct Condition {
    const char* key;
    bool (*holds)(const SceneSpec& scene);
};

constexpr Condition k_conditions[] = {
    {"release.thickness-direction", [](const SceneSpec& s) { return s.release.thickness.has_value(); }},
    {"release.dtm-contains-release", [](const SceneSpec& s) { return s.release.thickness.has_value(); }},
    {"release.slip-shape",
     [](const SceneSpec& s) { return s.release.thickness.has_value() && s.release.thickness->fitted(); }},
    {"zones.beyond-dtm",
     [](const SceneSpec& s) {
         return s.zones.friction_angle || s.zones.friction_coefficient || s.zones.turbulence || s.zones.cohesion ||
                s.zones.erodible_depth;
     }},
    {"numerics.flight-angle", [](const SceneSpec& s) { return flight(s.numerics); }},
    {"numerics.flight-clearance", [](const SceneSpec& s) { return flight(s.numerics); }},
    {"numerics.flight-drag", [](const SceneSpec& s) { return flight(s.numerics); }},
    {"time.stop-change", [](const SceneSpec& s) { return s.time.stop_change > 0; }},
    {"time.stop-window", [](const SceneSpec& s) { return s.time.stop_change > 0; }},
    {"time.stop-energy-fraction", [](const SceneSpec& s) { return s.time.stop_energy_fraction > 0; }},
    {"time.stop-moving-fraction", [](const SceneSpec& s) { return s.time.stop_moving_fraction > 0; }},
    {"time.stop-momentum", [](const SceneSpec& s) { return s.time.stop_momentum > 0; }},
    {"time.frame-interval", [](const SceneSpec&) { return false; }},
    {"observed.threshold",
     [](const SceneSpec& s) { return s.observed.perimeter || s.observed.front || s.observed.deposit; }},
    {"hazard.minimum-depth", [](const SceneSpec& s) { return s.hazard.scheme.has_value(); }},
    {"output.trace-threshold", [](const SceneSpec&) { return true; }},
};

bool is_read(const SceneSpec& scene, const std::string& name, const std::string& section) {
    if (!model_reads(scene, name)) return false;
    for (const Condition& condition : k_conditions)
        if (name == condition.key) return condition.holds(scene);
    if (section == "scene" || section == "output") return false;
    const std::vector<std::string> of_laws = law_keys();
    return std::find(of_laws.begin(), of_laws.end(), name) == of_laws.end() ||
           !readers_of(name, laws_of(scene)).empty();
}

}  // namespace

bool is_used(const SceneSpec& scene, const Parameter& key, bool is_chosen) {
    const std::string name = key.name();
    if (scene.origin_of(name) != Origin::default_value) return true;
    const bool has_value = is_chosen || !key.write(scene).value_or("").empty();
    return has_value && is_read(scene, name, key.section);
}

}  // namespace frana
