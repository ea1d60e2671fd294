// SPDX-License-Identifier: Apache-2.0
#include "params/check/check_laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/shortest_text.h"
#include "params/grammar/value_text.h"
#include "params/keys/law_names.h"

namespace frana {
namespace {

bool holds(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// Who asks for a law: the key that names it.
std::string asked_by(const std::string& law) {
    if (law == "deposition") return "entrainment.deposition = on";
    if (law == "earth-pressure") return "material.in-plane-stress = earth-pressure";
    if (holds(erosion_names(), law)) return "entrainment.erosion = " + law;
    return "material.bed-friction = " + law;
}

/// Whether [zones] gives what the key of another section would: nothing outside the zones is then a fair default.
bool by_place(const std::set<std::string>& given, const std::string& name) {
    return given.count("zones." + name.substr(name.find('.') + 1)) > 0;
}

void check_keys(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    const std::vector<std::string> laws = laws_of(scene);
    for (const LawKey& key : law_keys()) {
        bool is_given = given.count(key.name) > 0;
        if (key.name == "material.turbulence" && !scene.material.turbulence) is_given = false;  // "off"
        const bool read =
            std::any_of(key.laws.begin(), key.laws.end(), [&](const std::string& law) { return holds(laws, law); });
        if (is_given && !read) {
            std::vector<std::string> askers;
            for (const std::string& law : key.laws) askers.push_back(asked_by(law));
            problems.add({"is given, but no law of the scene reads it", file + ": " + key.name, "", "",
                          "Remove it, or set " + joined(askers, " or ")});
        }
        for (const std::string& law : key.needs) {
            if (is_given || !holds(laws, law) || by_place(given, key.name)) continue;
            problems.add({"is missing", file + ": " + key.name, "", "", asked_by(law) + " needs it"});
        }
    }
}

void check_friction(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                    Problems& problems) {
    const std::vector<std::string> laws = laws_of(scene);
    const MaterialSpec& m = scene.material;
    const bool has_friction = given.count("material.friction-angle") + given.count("material.friction-coefficient") > 0;
    if (!has_friction && (holds(laws, "coulomb") || holds(laws, "ramms-yield") || holds(laws, "pouliquen-forterre") ||
                          holds(laws, "earth-pressure"))) {
        problems.add({"no bed friction is given", file + ": material.friction-angle", "", "",
                      "Set material.preset (see `frana materials`), material.friction-angle or "
                      "material.friction-coefficient; 0 is allowed, but must be said"});
    }
    const std::vector<std::string> terms = bed_friction_terms(m);
    const bool bed_bingham = holds(terms, "bingham"), bed_hb = holds(terms, "herschel-bulkley");
    const bool bed_obj = holds(terms, "obrien-julien");
    const bool pouliquen = holds(terms, "pouliquen-forterre");
    if (bed_bingham + bed_hb + bed_obj + pouliquen > 1) {
        problems.add({"names two laws for one thing", file + ": material.bed-friction", joined(terms, ", "),
                      "one of bingham, herschel-bulkley, obrien-julien and pouliquen-forterre", "Keep one of them"});
    }
    if (pouliquen && holds(terms, "coulomb")) {
        problems.add({"names two laws for one thing", file + ": material.bed-friction", joined(terms, ", "),
                      "coulomb (or voellmy) or pouliquen-forterre", "Keep one of them"});
    }
    if (bed_bingham && !(m.viscosity > 0)) {
        problems.add({"must be greater than 0", file + ": material.viscosity", shortest_text(m.viscosity), "",
                      "material.bed-friction = bingham needs it"});
    }
    if (bed_bingham && m.yield_ratio == "quadratic" && !(m.yield_stress > 0)) {
        problems.add({"must be greater than 0", file + ": material.yield-stress", shortest_text(m.yield_stress), "",
                      "yield-ratio = quadratic needs it; exact does without"});
    }
    const bool reads_yield = bed_bingham || bed_hb || bed_obj || in_plane_stress(m) == "bingham";
    if (!reads_yield && (m.yield_stress > 0 || m.viscosity > 0)) {
        const std::string name = m.yield_stress > 0 ? "material.yield-stress" : "material.viscosity";
        problems.add({"is given, but no law of the scene reads it", file + ": " + name, "", "",
                      "Remove it, or choose another in-plane-stress or bed-friction"});
    }
    if (m.surface_pressure > 0 && !holds(terms, "coulomb")) {
        problems.add({"is given, but no law of the scene reads it", file + ": material.surface-pressure", "", "",
                      "Remove it, or set material.bed-friction = coulomb"});
    }
}

void check_angles(const SceneSpec& scene, const std::string& file, Problems& problems) {
    const MaterialSpec& m = scene.material;
    if (!m.friction_angle && !m.friction_coefficient) return;
    const double bed_deg = std::atan(friction_coefficient(m)) * 180 / std::numbers::pi;
    const std::vector<std::string> laws = laws_of(scene);
    const auto check = [&](const std::string& law, const std::string& key, const std::optional<double>& angle_deg) {
        // A grain of tolerance, so that an angle equals the arctangent of its tangent.
        if (!angle_deg || !holds(laws, law) || *angle_deg >= bed_deg - 1e-9) return;
        problems.add({"is less than the friction angle of the bed", file + ": material." + key,
                      shortest_text(*angle_deg) + " degrees", "at least " + shortest_text(bed_deg) + " degrees",
                      law + " is not defined below it"});
    };
    check("earth-pressure", "internal-friction-angle", m.internal_friction_angle);
    check("pouliquen-forterre", "fast-friction-angle", m.fast_friction_angle);
    if (holds(laws, "ramms-yield") && friction_coefficient(m) > 1) {
        problems.add({"is too large for the law ramms-yield", file + ": material.friction-coefficient",
                      shortest_text(friction_coefficient(m)), "0 to 1", "Its term (1 - mu) N_0 would be negative"});
    }
}

void check_rest(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems) {
    if (scene.entrainment.erosion != "off" && given.count("entrainment.erodible-depth") == 0 &&
        !by_place(given, "entrainment.erodible-depth")) {
        problems.add({"is missing", file + ": entrainment.erodible-depth", "", "",
                      "Give the depth in metres that can be eroded, here or in zones.erodible-depth"});
    }
    if (scene.material.pore_dissipation_time && !(scene.material.pore_pressure_ratio.value_or(0) > 0)) {
        problems.add({"is given without a pore pressure", file + ": material.pore-dissipation-time", "", "",
                      "Set material.pore-pressure-ratio, or remove it"});
    }
    // One clock for all particles: what joins later would come with pore pressure that has already gone.
    const auto& start = scene.release.start;
    const bool fails_late = start && (start->kind != SourceSpec::Kind::number || start->number > 0);
    if (scene.material.pore_dissipation_time && (fails_late || scene.inflow.line)) {
        problems.add({std::string("counts from the start of the run, but ") +
                          (fails_late ? "areas fail later (release.start)" : "material flows in later (inflow.line)"),
                      file + ": material.pore-dissipation-time",
                      shortest_text(*scene.material.pore_dissipation_time) + " s", "",
                      "Remove it (the pore pressure then stays), or compute each failure in a run of its own"});
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
