// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/keys/scene_spec.h"

namespace frana {

/// A law of bed friction: what may differ from place to place for it, and whether the bed takes at least the friction
/// coefficient times the normal stress from whatever moves on it, so that an energy line bounds how far that gets.
struct BedLaw {
    std::string word;  ///< of material.bed-friction
    bool reads_friction = false, reads_turbulence = false, reads_cohesion = false;
    bool resists_with_friction = false;
};
/// All of them, voellmy taken apart.
const std::vector<BedLaw>& bed_laws();
/// Those that a material asks for.
std::vector<BedLaw> bed_laws_of(const MaterialSpec& material);

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
