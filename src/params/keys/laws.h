// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/keys/scene_spec.h"

namespace frana {

/// Which key asks for a law.
enum class LawKind { bed_friction, in_plane_stress, erosion, deposition };

/// A law that a scene of the first model may ask for. This is the one list: the words of the keys, which keys are
/// missing or read by nothing, which zones are used, laws that exclude each other, the list of terms and the energy
/// line of a large terrain follow from it.
struct Law {
    std::string word;  ///< of the key that asks for it; "on" for deposition
    LawKind kind = LawKind::bed_friction;
    std::string sentence;                       ///< in the list of terms
    std::vector<std::string> reads{}, needs{};  ///< keys; what it needs it reads as well
    std::vector<std::string> resists_alike{};   ///< resistances of which a scene may have one law only
    /// The bed takes at least the friction coefficient times the normal stress from whatever moves on it, so that an
    /// energy line bounds how far that gets.
    bool resists_with_friction = false;

    [[nodiscard]] bool reads_key(const std::string& name) const;
    /// Laws at the bed read by place whatever [zones] gives of their keys; stress in the plane is the same everywhere.
    [[nodiscard]] bool reads_zone(const std::string& name) const;
    /// "material.bed-friction = chezy"
    [[nodiscard]] std::string asked_by() const;
};
const std::vector<Law>& laws();
/// One that must be there.
const Law& find_law(LawKind kind, const std::string& word);
/// Every law that a scene asks for; none of the structured model.
std::vector<const Law*> laws_of(const SceneSpec& scene);
/// Which of several read a key.
std::vector<const Law*> readers_of(const std::string& key, const std::vector<const Law*>& among);
/// All of the table.
std::vector<const Law*> readers_of(const std::string& key);
/// What asks for one of them: "material.bed-friction = bingham or manning or entrainment.erosion = growth".
std::string asked_by(const std::vector<const Law*>& some);
/// Every key that laws read, each once.
std::vector<std::string> law_keys();

/// The words that ask for laws of a kind, between others of their key: "voellmy", which is two laws, or "off".
std::vector<std::string> law_words(const std::string& first, LawKind kind, const std::vector<std::string>& last = {});
/// The words of the laws of bed friction that a material asks for, voellmy taken apart, each once.
std::vector<std::string> bed_friction_terms(const MaterialSpec& material);
/// Resolved: bingham, earth-pressure or none.
std::string in_plane_stress(const MaterialSpec& material);

}  // namespace frana
