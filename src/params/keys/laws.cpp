// SPDX-License-Identifier: Apache-2.0
#include "params/keys/laws.h"

#include <algorithm>
#include <stdexcept>

#include "core/text.h"
#include "physics/laws.h"

namespace frana {
namespace {

bool in_section(const std::string& name, const std::string& section) {
    return name.rfind(section + ".", 0) == 0;
}

// Keys outside [material], [zones] and [entrainment] for the particles of the first model only.
const std::set<std::string> k_voellmy_bingham_only{
    "material.preset",        "terrain.friction-zones", "numerics.scheme", "numerics.transfer",
    "numerics.well-balanced", "numerics.curvature",     "numerics.flight", "numerics.flight-clearance"};

// Keys of [structured] that pure fluid reads too, besides those of the soil.
const std::set<std::string> k_fluid_keys{
    "structured.phases",    "structured.fluid-density", "structured.fluid-viscosity",     "structured.manning",
    "structured.dry-depth", "structured.zones",         "structured.initial-fluid-depth", "structured.rain"};

bool has_solids(const SceneSpec& scene) {
    return scene.structured.phases == "solids-and-fluid";
}

void check_solids(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                  Problems& problems) {
    const StructuredSpec& s = scene.structured;
    for (const char* key : {"structured.cohesion", "structured.internal-friction-angle"}) {
        if (given.count(key) == 0)
            problems.add({"is missing", Place(file, key), "", "", "structured.phases = solids-and-fluid needs it"});
    }
    if (!(s.young_modulus < 9 * s.bulk_modulus)) {
        problems.add({"makes the material unstable", Place(file, "structured.young-modulus"),
                      shortest_text(s.young_modulus) + " Pa",
                      "less than 9 times structured.bulk-modulus, " + shortest_text(9 * s.bulk_modulus) + " Pa",
                      "Lower it or raise the bulk modulus"});
    }
    const auto& thickness = scene.release.thickness;
    if (thickness && thickness->in_phases() && given.count("structured.solid-fraction") > 0) {
        problems.add({"is given twice", Place(file, "structured.solid-fraction"), "", "",
                      "Remove it: release.thickness = " + text_of(*thickness) + " determines it"});
    }
    if (scene.numerics.particles_per_cell < 9) {
        problems.add({"is too small for the neighbour sums of solids", Place(file, "numerics.particles-per-cell"),
                      std::to_string(scene.numerics.particles_per_cell), "9, 16", "Set it to 9"});
    }
}

void check_structured(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                      Problems& problems) {
    if (!scene.structured.phases) {
        problems.add({"is missing", Place(file, "structured.phases"), "", "fluid, solids-and-fluid",
                      "State the content of the release"});
    }
    if (scene.numerics.slope_correction == SlopeCorrection::surface) {
        problems.add({"is not available for material.model = structured", Place(file, "numerics.slope-correction"),
                      "surface", "auto, none, normal", "Choose normal or none"});
    }
    if (has_solids(scene)) check_solids(scene, given, file, problems);
}

}  // namespace

bool solids_read(const std::string& name) {
    static const std::vector<std::string> names = PoreValues::names({});
    return std::find(names.begin(), names.end(), name) != names.end() && name != "material.pore-fluid-density" &&
           name != "material.solid-fraction";
}

bool model_reads(const SceneSpec& scene, const std::string& name) {
    if (scene.material.model != "structured") return !in_section(name, "structured");
    if (in_section(name, "structured"))
        return k_fluid_keys.count(name) > 0 || name.starts_with("structured.soil-") || has_solids(scene);
    if (name == "material.model" || (solids_read(name) && has_solids(scene))) return true;
    return !in_section(name, "material") && !in_section(name, "zones") && !in_section(name, "entrainment") &&
           k_voellmy_bingham_only.count(name) == 0;
}

void check_model(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems) {
    const bool structured = scene.material.model == "structured";
    for (const std::string& name : given) {
        // Keys of a preset are not keys of the scene: the preset itself is refused.
        if (model_reads(scene, name) || scene.origin_of(name) == Origin::preset) continue;
        const bool solids_key = structured && in_section(name, "structured");
        const std::string reader = solids_key ? "structured.phases = " + scene.structured.phases.value_or("(missing)")
                                              : "material.model = " + scene.material.model;
        problems.add({"is given, but " + reader + " does not use it", Place(file, name), "", "",
                      solids_key ? "Remove it, or set structured.phases = solids-and-fluid"
                                 : "Remove it, or choose the other model"});
    }
    if (structured) check_structured(scene, given, file, problems);
    const auto& thickness = scene.release.thickness;
    if (thickness && thickness->in_phases() && !(structured && has_solids(scene))) {
        problems.add({"gives solids and fluid separately, but the scene's material does not",
                      Place(file, "release.thickness"), text_of(*thickness), "",
                      "Set structured.phases = solids-and-fluid, or give the sum as raster:FILE"});
    }
}

namespace {

using Texts = std::vector<std::string>;

bool contains(const Texts& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

Texts operator+(Texts a, const Texts& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

template <class L>
Law row_of(LawKind kind) {
    Law row = L::row();
    row.word = L::word;
    row.kind = kind;
    for_each_key<L>([&](const auto& key) { (key.needed() ? row.needs : row.reads).emplace_back(key.name); });
    return row;
}

std::vector<Law> table_of_laws() {
    std::vector<Law> table;
    for_each_law_list(
        [&]<class List>() { List::for_each([&]<class L>() { table.push_back(row_of<L>(List::kind)); }); });
    return table;
}

}  // namespace

const std::vector<Law>& laws() {
    static const std::vector<Law> table = table_of_laws();
    return table;
}

const Law& find_law(LawKind kind, const std::string& word) {
    const auto found = std::find_if(laws().begin(), laws().end(),
                                    [&](const Law& law) { return law.kind == kind && law.word == word; });
    if (found == laws().end()) throw std::out_of_range("no law " + word);
    return *found;
}

std::vector<const Law*> laws_of(const SceneSpec& scene) {
    std::vector<const Law*> some;
    if (scene.material.model == "structured") return some;
    const Texts terms = bed_friction_terms(scene.material);
    for (const Law& law : laws()) {
        const bool selected = (law.kind == LawKind::bed_friction && contains(terms, law.word)) ||
                              (law.kind == LawKind::in_plane_stress && law.word == in_plane_stress(scene.material)) ||
                              (law.kind == LawKind::erosion && law.word == scene.entrainment.erosion) ||
                              (law.kind == LawKind::deposition && scene.entrainment.deposition) ||
                              (law.kind == LawKind::detrainment && scene.entrainment.detrainment);
        if (selected) some.push_back(&law);
    }
    return some;
}

std::vector<const Law*> readers_of(const std::string& key, const std::vector<const Law*>& among) {
    std::vector<const Law*> some;
    const bool zone = key.rfind("zones.", 0) == 0;
    for (const Law* law : among)
        if (zone ? law->reads_zone(key) : law->reads_key(key)) some.push_back(law);
    return some;
}

std::vector<const Law*> readers_of(const std::string& key) {
    std::vector<const Law*> all;
    for (const Law& law : laws()) all.push_back(&law);
    return readers_of(key, all);
}

std::string selected_by(const std::vector<const Law*>& some) {
    std::string text;
    for (std::size_t i = 0; i < some.size(); ++i) {
        const bool same_key = i > 0 && some[i]->kind == some[i - 1]->kind;
        text += (i > 0 ? " or " : "") + (same_key ? some[i]->word : some[i]->selected_by());
    }
    return text;
}

Texts law_keys() {
    Texts keys;
    for (const Law& law : laws())
        for (const std::string& key : law.reads + law.needs)
            if (!contains(keys, key)) keys.push_back(key);
    return keys;
}

Texts law_words(const std::string& first, LawKind kind, const Texts& last) {
    Texts words{first};
    for (const Law& law : laws())
        if (law.kind == kind) words.push_back(law.word);
    return words + last;
}

Texts bed_friction_terms(const Material& material) {
    Texts terms;
    const auto add = [&](const std::string& word) {
        if (!contains(terms, word)) terms.push_back(word);
    };
    for (const std::string& word : material.bed_friction) {
        if (word == "voellmy") {
            add(CoulombFriction::word);
            add(TurbulentFriction::word);
        } else {
            add(word);
        }
    }
    return terms;
}

std::string in_plane_stress(const Material& material) {
    if (material.in_plane_stress != "auto") return material.in_plane_stress;
    if (!material.of<BinghamStress>().has_bingham_stress()) return "none";
    for (const std::string& word : bed_friction_terms(material))
        if (find_law(LawKind::bed_friction, word).reads_key("material.yield-stress")) return "none";
    return BinghamStress::word;
}

std::optional<double> friction_coefficient_of(const Material& material) {
    const CoulombFriction::Values& values = material.of<CoulombFriction>();
    if (!values.friction_angle && !values.friction_coefficient) return {};
    return values.bed_friction_coefficient();
}

PorePressure pore_pressure_of(const Material& material) {
    return material.of<CoulombFriction>().pore_pressure(material.density);
}

}  // namespace frana
