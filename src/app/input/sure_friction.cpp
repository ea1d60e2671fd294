// SPDX-License-Identifier: Apache-2.0
#include "app/input/sure_friction.h"

#include <algorithm>
#include <vector>

#include "params/keys/laws.h"
#include "params/keys/zone_keys.h"

namespace frana::app {

double sure_friction(const SceneSpec& scene) {
    bool by_place = scene.terrain.friction_zones.has_value();
    for (const ZoneKey& key : zone_keys()) by_place = by_place || (key.what == "friction" && scene.zones.*key.source);
    const std::vector<const Law*> laws = laws_of(scene);
    const bool resists =
        std::any_of(laws.begin(), laws.end(), [](const Law* law) { return law->resists_with_friction; });
    if (by_place || !resists || (!scene.material.friction_angle && !scene.material.friction_coefficient)) return 0;
    return friction_coefficient(scene.material) * (1 - scene.material.pore_pressure_ratio.value_or(0));
}

}  // namespace frana::app
