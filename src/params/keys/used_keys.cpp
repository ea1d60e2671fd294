// SPDX-License-Identifier: Apache-2.0
#include "params/keys/used_keys.h"

#include <algorithm>

#include "params/keys/laws.h"
#include "params/keys/model_keys.h"

namespace frana {
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
    {"numerics.flight-slope", [](const SceneSpec& s) { return flight(s.numerics); }},
    {"time.stop-change", [](const SceneSpec& s) { return s.time.stop_change > 0; }},
    {"time.stop-window", [](const SceneSpec& s) { return s.time.stop_change > 0; }},
    {"time.stop-energy-fraction", [](const SceneSpec& s) { return s.time.stop_energy_fraction > 0; }},
    {"time.stop-moving-fraction", [](const SceneSpec& s) { return s.time.stop_moving_fraction > 0; }},
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
