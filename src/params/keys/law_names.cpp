// SPDX-License-Identifier: Apache-2.0
#include "params/keys/law_names.h"

#include <algorithm>

namespace frana {
namespace {

bool holds(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

const std::vector<BedLaw>& bed_laws() {
    static const std::vector<BedLaw> laws{
        {"coulomb", true, false, false, true},
        {"turbulence", false, true},
        {"cohesion", false, false, true},
        {"ramms-yield", true},  // resists with (1 - mu) N_0: the less, the greater mu is
        {"bingham"},
        {"herschel-bulkley"},
        {"obrien-julien"},
        {"manning"},
        {"chezy"},
        {"pouliquen-forterre", true, false, false, true}};  // mu(I) is nowhere less than its slowest
    return laws;
}

std::vector<BedLaw> bed_laws_of(const MaterialSpec& material) {
    const std::vector<std::string> terms = bed_friction_terms(material);
    std::vector<BedLaw> laws;
    for (const BedLaw& law : bed_laws())
        if (holds(terms, law.word)) laws.push_back(law);
    return laws;
}

std::vector<std::string> bed_friction_names() {
    std::vector<std::string> names{"voellmy"};
    for (const BedLaw& law : bed_laws()) names.push_back(law.word);
    return names;
}

std::vector<std::string> erosion_names() {
    return {"off", "shear-stress", "growth", "mechanical"};
}

std::vector<std::string> bed_friction_terms(const MaterialSpec& material) {
    std::vector<std::string> terms;
    const auto add = [&](const std::string& word) {
        if (!holds(terms, word)) terms.push_back(word);
    };
    for (const std::string& word : material.bed_friction) {
        if (word == "voellmy") {
            add("coulomb");
            add("turbulence");
        } else {
            add(word);
        }
    }
    return terms;
}

std::string in_plane_stress(const MaterialSpec& material) {
    if (material.in_plane_stress != "auto") return material.in_plane_stress;
    if (!(material.viscosity > 0) && !(material.yield_stress > 0)) return "none";
    for (const std::string& term : bed_friction_terms(material)) {
        if (term == "bingham" || term == "herschel-bulkley" || term == "obrien-julien") return "none";
    }
    return "bingham";
}

const std::vector<LawKey>& law_keys() {
    static const std::vector<LawKey> keys{
        {"material.friction-angle", {"coulomb", "ramms-yield", "pouliquen-forterre", "earth-pressure"}, {}},
        {"material.friction-coefficient", {"coulomb", "ramms-yield", "pouliquen-forterre", "earth-pressure"}, {}},
        {"material.turbulence", {"turbulence"}, {}},
        {"material.pore-pressure-ratio", {"coulomb", "pouliquen-forterre"}, {}},
        {"material.pore-dissipation-time", {"coulomb", "pouliquen-forterre"}, {}},
        {"material.cohesion", {"cohesion"}, {"cohesion"}},
        {"material.ramms-yield-stress", {"ramms-yield"}, {"ramms-yield"}},
        {"material.manning", {"manning", "obrien-julien"}, {"manning"}},
        {"material.chezy", {"chezy"}, {"chezy"}},
        {"material.laminar-resistance", {"obrien-julien"}, {}},
        {"material.consistency", {"herschel-bulkley"}, {"herschel-bulkley"}},
        {"material.flow-index", {"herschel-bulkley"}, {"herschel-bulkley"}},
        {"material.fast-friction-angle", {"pouliquen-forterre"}, {"pouliquen-forterre"}},
        {"material.friction-length", {"pouliquen-forterre"}, {"pouliquen-forterre"}},
        {"material.friction-beta", {"pouliquen-forterre"}, {}},
        {"material.internal-friction-angle", {"earth-pressure"}, {"earth-pressure"}},
        {"entrainment.erodible-depth", {"shear-stress", "growth", "mechanical"}, {}},
        {"entrainment.erosion-rate", {"shear-stress"}, {}},
        {"entrainment.critical-shear", {"shear-stress"}, {}},
        {"entrainment.potential-depth", {"shear-stress"}, {}},
        {"entrainment.growth-rate", {"growth"}, {"growth"}},
        {"entrainment.bed-friction-angle", {"mechanical"}, {"mechanical"}},
        {"entrainment.bed-cohesion", {"mechanical"}, {}},
        {"entrainment.bed-pore-pressure-ratio", {"mechanical"}, {}},
        {"entrainment.velocity-ratio", {"mechanical"}, {}},
        {"entrainment.deposition-rate", {"deposition"}, {"deposition"}},
        {"entrainment.deposition-shear", {"deposition"}, {"deposition"}}};
    return keys;
}

std::vector<std::string> laws_of(const SceneSpec& scene) {
    std::vector<std::string> laws = bed_friction_terms(scene.material);
    laws.push_back(in_plane_stress(scene.material));
    laws.push_back(scene.entrainment.erosion);
    if (scene.entrainment.deposition) laws.emplace_back("deposition");
    return laws;
}

}  // namespace frana
