// SPDX-License-Identifier: Apache-2.0
#include "params/check/check_laws.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/shortest_text.h"
#include "params/grammar/value_text.h"
#include "params/keys/laws.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

bool selects(const std::vector<const Law*>& laws, LawKind kind, const std::string& word) {
    return std::find(laws.begin(), laws.end(), &find_law(kind, word)) != laws.end();
}

/// Whether [zones] has the same quantity as the key of another section: the default then applies outside the zones.
bool by_place(const std::set<std::string>& given, const std::string& name) {
    return given.count("zones." + name.substr(name.find('.') + 1)) > 0;
}

void check_keys(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const std::vector<const Law*> selected = laws_of(scene);
    for (const std::string& name : law_keys()) {
        const Parameter& key = *find_parameter(parameters, name);
        const std::string preset = key.default_text(), value = key.write(scene).value_or("");
        // A key given with its default value requests nothing.
        const bool is_given = given.count(name) > 0 && (preset.empty() || value != preset);
        if (is_given && readers_of(name, selected).empty()) {
            problems.add({"is given, but no law of the scene uses it", file + ": " + name, "", "",
                          "Remove it, or set " + selected_by(readers_of(name))});
        }
        for (const Law* law : selected) {
            const bool needs = std::find(law->needs.begin(), law->needs.end(), name) != law->needs.end();
            if (!needs || is_given || by_place(given, name)) continue;
            const bool zones = find_parameter(parameters, "zones." + key.key) != nullptr;
            problems.add({preset.empty() ? "is missing" : "must be greater than " + preset, file + ": " + name, value,
                          "", law->selected_by() + " needs it" + (zones ? ", here or in zones." + key.key : "")});
        }
    }
}

void check_friction(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                    Problems& problems) {
    const std::vector<const Law*> selected = laws_of(scene);
    const bool has_friction = given.count("material.friction-angle") + given.count("material.friction-coefficient") > 0;
    if (!has_friction && !readers_of("material.friction-angle", selected).empty()) {
        problems.add({"no bed friction is given", file + ": material.friction-angle", "", "",
                      "Set material.preset (see `frana materials`), material.friction-angle or "
                      "material.friction-coefficient; 0 is allowed, but must be given"});
    }
    std::map<std::string, std::vector<std::string>> alike;
    for (const Law* law : selected)
        for (const std::string& what : law->resists_alike) alike[what].push_back(law->word);
    for (const auto& [what, words] : alike) {
        if (words.size() < 2) continue;
        problems.add({"names two laws for the same effect, the " + what, file + ": material.bed-friction",
                      joined(words, ", "), "one of them", "Keep one of them"});
    }
    if (selects(selected, LawKind::bed_friction, "bingham") && !scene.material.exact_yield_ratio &&
        !(scene.material.yield_stress > 0)) {
        problems.add({"must be greater than 0", file + ": material.yield-stress",
                      shortest_text(scene.material.yield_stress), "",
                      "yield-ratio = quadratic needs it; exact does not"});
    }
}

void check_angles(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const MaterialSpec& m = scene.material;
    if (!m.friction_angle && !m.friction_coefficient) return;
    const double bed_deg = std::atan(friction_coefficient(m)) * 180 / std::numbers::pi;
    const std::vector<const Law*> laws = laws_of(scene);
    const auto check = [&](LawKind kind, const std::string& law, const std::string& key,
                           const std::optional<double>& angle_deg) {
        // The tolerance makes an angle equal the arctangent of its tangent.
        if (!angle_deg || !selects(laws, kind, law) || *angle_deg >= bed_deg - 1e-9) return;
        problems.add({"is less than the friction angle of the bed", file + ": material." + key,
                      shortest_text(*angle_deg) + " degrees", "at least " + shortest_text(bed_deg) + " degrees",
                      law + " is not defined below it"});
    };
    check(LawKind::in_plane_stress, "earth-pressure", "internal-friction-angle", m.internal_friction_angle);
    check(LawKind::bed_friction, "pouliquen-forterre", "fast-friction-angle", m.fast_friction_angle);
    for (const Law* law : laws) {
        if (friction_coefficient(m) <= law->greatest_friction) continue;
        problems.add({"is too large for the law " + law->word, file + ": material.friction-coefficient",
                      shortest_text(friction_coefficient(m)), "0 to " + shortest_text(law->greatest_friction),
                      "It is not defined above that"});
    }
}

void check_rest(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    if (scene.material.pore_dissipation_time && !(scene.material.pore_pressure_ratio.value_or(0) > 0)) {
        problems.add({"is given without a pore pressure", file + ": material.pore-dissipation-time", "", "",
                      "Set material.pore-pressure-ratio, or remove it"});
    }
    // One time for all particles: material that enters later would start with pore pressure already dissipated.
    const auto& start = scene.release.start;
    const bool fails_late = start && (start->kind != SourceSpec::Kind::number || start->number > 0);
    if (scene.material.pore_dissipation_time && (fails_late || given.count("inflow.line") > 0)) {
        problems.add({std::string("counts from the start of the run, but ") +
                          (fails_late ? "areas fail later (release.start)" : "material flows in later (inflow.line)"),
                      file + ": material.pore-dissipation-time",
                      shortest_text(*scene.material.pore_dissipation_time) + " s", "",
                      "Remove it (the pore pressure then stays constant), or compute each failure in a separate run"});
    }
    if (curvature(scene.numerics) && slope_correction(scene.numerics) == "none") {
        problems.add({"needs a slope correction", file + ": numerics.curvature", "on", "off",
                      "Set numerics.slope-correction = normal or surface, or remove the key"});
    }
    if (flight(scene.numerics) && !can_fly(scene.numerics)) {
        problems.add({"needs numerics.curvature = on, scheme = default and transfer = apic", file + ": numerics.flight",
                      "on", "off", "Set those, or remove the key"});
    }
}

}  // namespace

void check_laws(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    check_keys(scene, given, file, problems);
    check_friction(scene, given, file, problems);
    check_angles(scene, file, problems);
    check_rest(scene, given, file, problems);
}

}  // namespace frana
