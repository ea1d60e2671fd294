// SPDX-License-Identifier: Apache-2.0
#include "params/keys/used_keys.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "params/keys/laws.h"
#include "params/keys/scene_parameters.h"

namespace frana {
namespace {

bool uses(const SceneSpec& scene, const std::string& name, bool is_chosen = false) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter* const key = find_parameter(parameters, name);
    EXPECT_NE(key, nullptr) << name;
    return key != nullptr && is_used(scene, *key, is_chosen);
}

// Each key of a law that has a value counts with the law and with no other.
TEST(UsedKeys, FollowTheLaws) {
    const std::vector<Parameter>& parameters = scene_parameters();
    for (const std::string& name : law_keys()) {
        const Parameter& key = *find_parameter(parameters, name);
        for (const Law& law : laws()) {
            SceneSpec scene;
            scene.material.bed_friction.clear();
            scene.material.in_plane_stress = "none";
            if (law.kind == LawKind::bed_friction) scene.material.bed_friction = {law.word};
            if (law.kind == LawKind::in_plane_stress) scene.material.in_plane_stress = law.word;
            if (law.kind == LawKind::erosion) scene.entrainment.erosion = law.word;
            if (law.kind == LawKind::deposition) scene.entrainment.deposition = true;
            if (law.kind == LawKind::detrainment) scene.entrainment.detrainment = true;
            EXPECT_EQ(is_used(scene, key, true), law.reads_key(name)) << name << " with " << law.word;
            scene.origins[name] = Origin::scene_file;
            EXPECT_TRUE(is_used(scene, key, false)) << name << " is given";
        }
    }
}

TEST(UsedKeys, FollowTheModelAndItsSwitches) {
    SceneSpec scene;
    EXPECT_TRUE(uses(scene, "numerics.minimum-depth"));
    EXPECT_TRUE(uses(scene, "material.density"));
    EXPECT_TRUE(uses(scene, "output.trace-threshold"));
    EXPECT_FALSE(uses(scene, "structured.young-modulus"));
    EXPECT_FALSE(uses(scene, "output.map-size"));
    EXPECT_FALSE(uses(scene, "terrain.walls")) << "has no value";
    EXPECT_TRUE(uses(scene, "terrain.cell-size", true)) << "chosen";
    EXPECT_TRUE(uses(scene, "numerics.flight-clearance"));
    scene.numerics.flight = false;
    EXPECT_FALSE(uses(scene, "numerics.flight-clearance"));
    scene.material.model = "structured";
    scene.structured.phases = "solids-and-fluid";
    EXPECT_TRUE(uses(scene, "structured.young-modulus"));
    EXPECT_FALSE(uses(scene, "material.density"));
    scene.structured.phases = "fluid";
    EXPECT_FALSE(uses(scene, "structured.young-modulus"));
}

}  // namespace
}  // namespace frana
