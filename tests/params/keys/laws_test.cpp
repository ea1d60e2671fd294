// SPDX-License-Identifier: Apache-2.0
// Laws of friction, stress, erosion and deposition: required keys, contradicting keys, the echo.
#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "params/keys/laws.h"
#include "params/keys/materials.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/zone_keys.h"
#include "params/scene/write_scene.h"
#include "physics/laws.h"
#include "scene_fixture.h"

namespace frana {
namespace {

const std::string k_ground = "[terrain]\ndtm = dtm.tif\n[release]\nperimeter = area.shp\nthickness = 2\n";

struct LawCase {
    std::string name, lines;
    std::string where{}, value{}, limit{};  ///< of the only problem; nowhere: the scene is accepted
    std::string remedy{};                   ///< a key that the remedy or the problem names
};

void PrintTo(const LawCase& tested, std::ostream* out) {
    *out << tested.name;
}

class LawKeys : public SceneFixture, public testing::WithParamInterface<LawCase> {};

TEST_P(LawKeys, AreCheckedTogether) {
    const std::vector<Problem> found = problems(k_ground + GetParam().lines);
    const LawCase& tested = GetParam();
    if (tested.where.empty()) {
        EXPECT_TRUE(no_problem(found));
        return;
    }
    EXPECT_TRUE(has_problem(found, tested.where, tested.value, tested.limit));
    EXPECT_EQ(found.size(), 1U) << "one problem, one message";
    EXPECT_NE(describe(found.front()).find(tested.remedy), std::string::npos) << describe(found.front());
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, LawKeys,
    testing::Values(
        LawCase{"voellmy", "[material]\nfriction-angle = 20\nturbulence = 300\n"},
        LawCase{"no_friction", "[material]\ndensity = 2000\n", "material.friction-angle"},
        LawCase{"cohesion", "[material]\nfriction-angle = 20\ncohesion = 500\nbed-friction = voellmy, cohesion\n"},
        LawCase{"cohesion_unread", "[material]\nfriction-angle = 20\ncohesion = 500\n", "material.cohesion", "", "",
                "material.bed-friction = cohesion"},
        LawCase{"unknown_law", "[material]\nfriction-angle = 20\nbed-friction = voellmi\n", "material.bed-friction",
                "voellmi"},
        LawCase{"bingham", "[material]\nbed-friction = bingham\nviscosity = 50\nyield-stress = 200\n"},
        LawCase{"bingham_without_viscosity", "[material]\nbed-friction = bingham\nyield-stress = 200\n",
                "material.viscosity", "0"},
        LawCase{"two_fluids", "[material]\nbed-friction = bingham, obrien-julien\nviscosity = 50\nyield-stress = 200\n",
                "material.bed-friction", "bingham, obrien-julien", "one of them"},
        LawCase{"friction_unread", "[material]\nbed-friction = manning\nmanning = 0.05\nfriction-angle = 20\n",
                "material.friction-angle"},
        LawCase{"negative_manning", "[material]\nbed-friction = manning\nmanning = -0.05\n", "material.manning",
                "-0.05", "greater than 0, at most 1 [s/m^(1/3)]"},
        LawCase{
            "solid_twice",
            "[material]\nbed-friction = coulomb, pouliquen-forterre\nfriction-angle = 20\nfast-friction-angle = 30\n"
            "friction-length = 1\n",
            "material.bed-friction", "coulomb, pouliquen-forterre", "one of them"},
        LawCase{"a_default_asks_for_nothing", "[material]\nfriction-angle = 20\nviscosity = 0\nsurface-pressure = 0\n"},
        LawCase{"yield_unread", "[material]\nfriction-angle = 20\nyield-stress = 100\nin-plane-stress = none\n",
                "material.yield-stress"},
        LawCase{"earth_pressure",
                "[material]\nfriction-angle = 20\nin-plane-stress = earth-pressure\ninternal-friction-angle "
                "= 30\n"},
        LawCase{"earth_pressure_too_smooth",
                "[material]\nfriction-angle = 35\nin-plane-stress = earth-pressure\ninternal-friction-angle = "
                "30\n",
                "material.internal-friction-angle", "30 degrees", "at least 35 degrees"},
        LawCase{"dissipation_without_pressure", "[material]\nfriction-angle = 35\npore-dissipation-time = 30\n",
                "material.pore-dissipation-time"},
        LawCase{"dissipation_from_the_start",
                "[material]\nfriction-angle = 35\npore-pressure-ratio = 0.4\npore-dissipation-time = 30\n"},
        LawCase{"dissipation_and_areas_that_fail_later",
                "[release]\nstart = 20\n[material]\nfriction-angle = 35\npore-pressure-ratio = 0.4\n"
                "pore-dissipation-time = 30\n"},
        LawCase{"dissipation_twice",
                "[material]\nfriction-angle = 35\npore-pressure-ratio = 0.4\npore-dissipation-time = 30\n"
                "hydraulic-diffusivity = 0.1\n",
                "material.pore-dissipation-time", "30 s", "", "Keep one"},
        LawCase{"consolidation",
                "[material]\nfriction-angle = 35\npore-fluid-density = 1000\nhydraulic-diffusivity = 0.1\n"},
        LawCase{"diffusivity_without_pressure", "[material]\nfriction-angle = 35\nhydraulic-diffusivity = 0.1\n",
                "material.hydraulic-diffusivity"},
        LawCase{"fluid_without_time",
                "[material]\nfriction-angle = 35\npore-pressure-ratio = 0.4\npore-fluid-density = 1000\n",
                "material.pore-fluid-density", "1000 kg/m3", "", "material.hydraulic-diffusivity"},
        LawCase{"fluid_denser_than_the_flow",
                "[material]\nfriction-angle = 35\ndensity = 1500\npore-fluid-density = 1600\n"
                "pore-dissipation-time = 30\n",
                "material.pore-fluid-density", "1600 kg/m3", "less than material.density, 1500 kg/m3"},
        LawCase{"dilatancy",
                "[material]\nfriction-angle = 35\nsolid-fraction = 0.5\ncritical-solid-fraction = 0.56\n"
                "compressibility = 1e-6\n"},
        LawCase{"dilatancy_without_the_state",
                "[material]\nfriction-angle = 35\ncritical-solid-fraction = 0.56\ncompressibility = 1e-6\n",
                "material.compressibility", "", "", "solid fraction"},
        LawCase{"dilatancy_without_the_critical_state",
                "[material]\nfriction-angle = 35\nsolid-fraction = 0.5\ncompressibility = 1e-6\n",
                "material.solid-fraction"},
        LawCase{"critical_state_without_compressibility",
                "[material]\nfriction-angle = 35\nsolid-fraction = 0.5\ncritical-solid-fraction = 0.56\n",
                "material.critical-solid-fraction"},
        LawCase{"erosion_without_layer", "[material]\nfriction-angle = 20\n[entrainment]\nerosion = shear-stress\n",
                "entrainment.erodible-depth"},
        LawCase{"growth_rate_of_another_law",
                "[material]\nfriction-angle = 20\n[entrainment]\nerosion = shear-stress\nerodible-depth = 1\n"
                "growth-rate = 0.01\n",
                "entrainment.growth-rate", "", "", "entrainment.erosion = growth"},
        LawCase{"deposition_without_rate",
                "[material]\nfriction-angle = 20\n[entrainment]\ndeposition = on\ndeposition-shear-stress = 500\n",
                "entrainment.deposition-rate"},
        LawCase{"detrainment_without_coefficient", "[material]\nfriction-angle = 20\n[entrainment]\ndetrainment = on\n",
                "entrainment.detrainment-coefficient"},
        LawCase{"curvature_in_the_gentle_form",
                "[material]\nfriction-angle = 20\n[numerics]\ncurvature = on\nslope-correction = none\n",
                "numerics.curvature", "on", "off"}),
    [](const auto& tested) { return tested.param.name; });

using Laws = SceneFixture;

// Keys named in the table exist, and each law is found by the keys that select it.
TEST_F(Laws, OfTheTableReadKeysThatExist) {
    const std::vector<Parameter>& parameters = scene_parameters();
    for (const std::string& key : law_keys()) EXPECT_NE(find_parameter(parameters, key), nullptr) << key;
    for (const ZoneKey& key : zone_keys()) EXPECT_FALSE(readers_of(key.name).empty()) << key.name;
    for (const Law& law : laws()) {
        EXPECT_EQ(&find_law(law.kind, law.word), &law);
        const std::string asked = law.selected_by(), key = asked.substr(0, asked.find(" ="));
        SceneSpec scene;
        EXPECT_FALSE(find_parameter(parameters, key)->read(scene, law.word)) << asked;
        const std::vector<const Law*> found = laws_of(scene);
        EXPECT_NE(std::find(found.begin(), found.end(), &law), found.end()) << asked;
    }
}

// The table of bed friction in share/doc/model.md names the keys that each law uses.
TEST_F(Laws, OfTheDocumentUseTheKeysOfTheTable) {
    std::ifstream file(FRANA_SOURCE_SHARE "/doc/model.md");
    std::map<std::string, std::set<std::string>> documented;
    const std::regex quoted("`([a-z-]+)`");
    for (std::string line; std::getline(file, line);) {
        std::smatch word;
        if (line.rfind("| `", 0) != 0 || !std::regex_search(line, word, quoted)) continue;
        const std::size_t cell = line.rfind('|', line.size() - 2);
        for (std::sregex_iterator key(line.begin() + static_cast<std::ptrdiff_t>(cell), line.end(), quoted), end;
             key != end; ++key)
            documented[word[1]].insert((*key)[1]);
    }
    for (const Law& law : laws()) {
        if (law.kind != LawKind::bed_friction) continue;
        std::set<std::string> used;
        for (const auto* keys : {&law.reads, &law.needs})
            for (const std::string& key : *keys) used.insert(key.substr(key.find('.') + 1));
        EXPECT_EQ(documented[law.word], used) << law.word;
    }
}

TEST_F(Laws, VoellmyIsSplitAndNothingIsCountedTwice) {
    Material material;
    material.bed_friction = {"voellmy", "coulomb", "cohesion"};
    EXPECT_EQ(bed_friction_terms(material), (std::vector<std::string>{"coulomb", "turbulence", "cohesion"}));
}

TEST_F(Laws, StressInThePlaneIsReplacedByTheBed) {
    Material material;
    EXPECT_EQ(in_plane_stress(material), "none");
    material.of<BinghamStress>().viscosity = 50;
    EXPECT_EQ(in_plane_stress(material), "bingham");
    material.bed_friction = {"bingham"};
    EXPECT_EQ(in_plane_stress(material), "none");
}

// A preset with Voellmy values, a scene with another law: the preset's friction is dropped, the echo can be run.
TEST_F(Laws, AnotherLawThanThePresetsDropsItsFriction) {
    const SceneReading reading =
        read(k_ground + "[material]\npreset = rock-avalanche\nbed-friction = manning\nmanning = 0.06\n");
    EXPECT_TRUE(reading.problems.empty()) << (reading.problems.empty() ? "" : describe(reading.problems.list()[0]));
    EXPECT_FALSE(reading.scene.material.of<CoulombFriction>().friction_coefficient);
    EXPECT_FALSE(reading.scene.material.of<TurbulentFriction>().turbulence);
    EXPECT_TRUE(no_problem(problems(scene_text(reading.scene, {}))));
}

// Values without a source in a preset must be given by the scene.
std::string keys_for_preset(const std::string& preset) {
    return preset == "earthflow" ? "viscosity = 20000\n" : "";
}

TEST_F(Laws, EveryPresetMakesASceneAsItsEchoDoesAndNamesItsSource) {
    const std::vector<MaterialPreset> presets = material_presets(FRANA_SOURCE_SHARE "/materials");
    ASSERT_GE(presets.size(), 5U);
    for (const MaterialPreset& preset : presets) {
        const SceneReading reading =
            read(k_ground + "[material]\npreset = " + preset.name + "\n" + keys_for_preset(preset.name));
        EXPECT_TRUE(reading.problems.empty())
            << preset.name << ": " << (reading.problems.empty() ? "" : describe(reading.problems.list()[0]));
        EXPECT_TRUE(no_problem(problems(scene_text(reading.scene, {})))) << preset.name;
        std::string comments;
        for (const std::string& line : preset.comments) comments += line + '\n';
        EXPECT_NE(comments.find("Source:"), std::string::npos) << preset.name;
        EXPECT_NE(comments.find("Range:"), std::string::npos) << preset.name;
    }
}

TEST_F(Laws, EarthflowWithoutAViscosityIsRefused) {
    const SceneReading reading = read(k_ground + "[material]\npreset = earthflow\n");
    ASSERT_EQ(reading.problems.list().size(), 1u);
    EXPECT_TRUE(has_problem(reading.problems.list(), "material.viscosity"));
}

}  // namespace
}  // namespace frana
