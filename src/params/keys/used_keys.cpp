// SPDX-License-Identifier: Apache-2.0
#include "params/keys/used_keys.h"

#include <algorithm>
#include <regex>
#include <string_view>

#include "core/words/words.h"
#include "params/keys/laws.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

/// A key that nearly every scene has, or whose own words do not say what it is. The first eight are those that a
/// dialogue shows, in this order.
struct KeyRow {
    std::string_view key;
    bool is_main = false;
    const char* title = "";
};
constexpr std::size_t k_first_keys = 8;
constexpr KeyRow k_rows[] = {
    {"terrain.dtm", true, "terrain model (DTM)"},
    {"release.perimeter", true, "release area"},
    {"release.thickness", true, "release thickness"},
    {"release.dtm-contains-release", true, "DTM contains the release"},
    {"material.return-period"},
    {"terrain.cell-size", true, "cell size"},
    {"observed.perimeter", true, "surveyed outline"},
    {"output.exposure"},
    {"material.preset", true, "material preset"},
    {"time.end", true, "longest simulated time"},
    {"numerics.accuracy", true, "accuracy, instead of a cell size"},
    {"output.maps", false, "maps"},
    {"output.language", false, "language of maps and report"},
    {"terrain.crs", true, "working CRS"},
    {"terrain.dtm-crs", false, "CRS of the DTM"},
    {"terrain.bounds", false, "part of the DTM"},
    {"terrain.nodata-policy", true, "ground without elevation"},
    {"terrain.nodata-value", false, "value that means no elevation"},
    {"terrain.error", false, "error of the elevations"},
    {"terrain.source", false, "source of the elevations"},
    {"release.level", false, "level of a released lake"},
    {"release.start", false, "time of failure"},
    {"release.velocity", false, "initial speed"},
    {"inflow.line", false, "lines of inflow"},
    {"material.bed-friction", false, "laws of bed friction"},
    {"structured.fluid-density", false, "density of the fluid"},
    {"structured.manning", false, "Manning n"},
    {"structured.solid-fraction", false, "fraction of solids"},
    {"structured.grain-density", false, "density of the grains"},
    {"structured.bed-friction-angle", false, "friction angle at the bed"},
    {"numerics.cfl", false, "Courant number"},
    {"observed.front", false, "surveyed front"},
    {"observed.deposit", false, "surveyed deposit"},
    {"observed.threshold", false, "depth that counts as covered"},
    {"terrain.vertical-unit", true},
    {"release.thickness-direction", true},
    {"material.friction-angle", true},
    {"material.turbulence", true},
    {"material.density", true},
    {"time.frame-interval", true},
    {"output.title", true},
    {"output.trace-threshold", true},
    {"hazard.scheme", true},
};

}  // namespace

bool is_main_key(const std::string& name) {
    return std::any_of(std::begin(k_rows), std::end(k_rows),
                       [&](const KeyRow& row) { return row.is_main && row.key == name; });
}

std::optional<std::size_t> place_in_dialogue(const std::string& name) {
    for (std::size_t place = 0; place < k_first_keys; ++place)
        if (name == k_rows[place].key) return place;
    return std::nullopt;
}

std::string title_of(const Parameter& key) {
    for (const KeyRow& row : k_rows)
        if (key.name() == row.key && *row.title != 0) return row.title;
    if (!key.called.empty()) return key.called;
    return key.key;
}

std::string title_in(const std::string& name, const Words& words) {
    const Parameter* const key = find_parameter(scene_parameters(), name);
    return key == nullptr ? name : words(title_of(*key));
}

namespace {

/// The meaning without the laws that use the key.
std::string own_meaning(const Parameter& key) {
    const std::string laws = used_by(key.name());
    return key.meaning.ends_with(laws) ? key.meaning.substr(0, key.meaning.size() - laws.size()) : key.meaning;
}

/// What makes a scene read a key of a law: "material.bed-friction = coulomb, manning; material.model = structured".
std::string selectors_of(const std::string& key) {
    static const std::regex k_next_key(" or (?=[a-z.-]+ =)"), k_next_word(" or ");
    return std::regex_replace(std::regex_replace(selected_by(readers_of(key)), k_next_key, "; "), k_next_word, ", ") +
           (solids_read(key) ? "; material.model = structured" : "");
}

}  // namespace

std::string used_by(const std::string& key) {
    return readers_of(key).empty() ? "" : " Used by " + selectors_of(key) + ".";
}

std::string meaning_in(const Parameter& key, const Words& words) {
    const std::string own = own_meaning(key);
    if (own == key.meaning) return words(own);
    return words(own) + " " + words("Used by {1}.", {selectors_of(key.name())});
}

std::vector<std::string> rows_of(const Parameter& key) {
    std::vector<std::string> rows{own_meaning(key)};
    if (const std::string title = title_of(key); title != key.key) rows.push_back(title);
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
    {"material.table-friction-factor", [](const SceneSpec& s) { return s.friction_table.name.has_value(); }},
    {"material.table-turbulence-factor", [](const SceneSpec& s) { return s.friction_table.name.has_value(); }},
    {"numerics.transfer", [](const SceneSpec& s) { return s.numerics.scheme != Scheme::finite_volume; }},
    {"numerics.particles-per-cell", [](const SceneSpec& s) { return s.numerics.scheme != Scheme::finite_volume; }},
    {"numerics.well-balanced", [](const SceneSpec& s) { return s.numerics.scheme != Scheme::finite_volume; }},
    {"numerics.flight-clearance", [](const SceneSpec& s) { return flight(s.numerics); }},
    {"time.stop-change", [](const SceneSpec& s) { return s.time.stop_change > 0; }},
    {"time.stop-momentum", [](const SceneSpec& s) { return s.time.stop_momentum > 0; }},
    {"time.frame-interval", [](const SceneSpec&) { return false; }},
    {"observed.perimeter-error", [](const SceneSpec& s) { return s.observed.perimeter.has_value(); }},
    {"observed.perimeter-bias", [](const SceneSpec& s) { return s.observed.perimeter_error.has_value(); }},
    {"observed.deposit-error", [](const SceneSpec& s) { return s.observed.deposit.has_value(); }},
    {"observed.error-length",
     [](const SceneSpec& s) { return s.observed.perimeter_error || s.observed.deposit_error; }},
    {"observed.threshold",
     [](const SceneSpec& s) { return s.observed.perimeter || s.observed.front || s.observed.deposit; }},
    {"hazard.minimum-depth", [](const SceneSpec& s) { return s.hazard.resolved && s.hazard.resolved->has_depths(); }},
    {"output.trace-threshold", [](const SceneSpec&) { return true; }},
};

bool is_read(const SceneSpec& scene, const std::string& name, const std::string& section) {
    if (!model_reads(scene, name) || (scene.friction_table.name && gives_by_table(name))) return false;
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
