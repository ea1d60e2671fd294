// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/scene_spec.h"

namespace frana {

/// The words of material.bed-friction.
std::vector<std::string> bed_friction_names();
/// The words of entrainment.erosion.
std::vector<std::string> erosion_names();

/// The laws of bed friction that a material asks for, voellmy taken apart, each once.
std::vector<std::string> bed_friction_terms(const MaterialSpec& material);
/// Resolved: bingham, earth-pressure or none.
std::string in_plane_stress(const MaterialSpec& material);

/// A key that only some laws read.
struct LawKey {
    std::string name;                ///< "material.cohesion"
    std::vector<std::string> laws;   ///< words of bed-friction, in-plane-stress or erosion, or "deposition"
    std::vector<std::string> needs;  ///< those of them that cannot do without it
};
const std::vector<LawKey>& law_keys();

/// Every law that a scene asks for, by the words of LawKey.
std::vector<std::string> laws_of(const SceneSpec& scene);

}  // namespace frana
