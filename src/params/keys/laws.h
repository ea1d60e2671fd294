// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Returns whether the model of a scene reads a key.
bool model_reads(const SceneSpec& scene, const std::string& name);

/// Reports keys of the scene that its model does not read, and keys that the structured model requires or does not
/// support.
/// @param given names given in the file or on the command line  @param file for messages
void check_model(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems);

/// The key that selects a law.
enum class LawKind { bed_friction, in_plane_stress, erosion, deposition };

/// A law of the first model. This is the one list, from which follow: the words of the keys, missing and unread keys,
/// the zones used, laws that exclude each other, the list of terms and the energy line of a large terrain.
struct Law {
    std::string word;  ///< of the key that selects it; "on" for deposition
    LawKind kind = LawKind::bed_friction;
    std::string sentence;                       ///< in the list of terms
    std::string yield_sentence{};               ///< the same for its yield stress, if that is a term of its own
    std::vector<std::string> reads{}, needs{};  ///< keys; those needed are also read
    std::vector<std::string> resists_alike{};   ///< resistances of which a scene may have only one law
    /// The bed resists with at least the friction coefficient times the normal stress, so that an energy line bounds
    /// the run-out.
    bool resists_with_friction = false;
    /// Friction coefficient up to which the law is defined: RAMMS's term (1 - mu) N_0 would be negative above 1.
    double greatest_friction = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool reads_key(const std::string& name) const;
    /// Bed laws read every key of [zones] that they read elsewhere; in-plane stress does not vary by place.
    [[nodiscard]] bool reads_zone(const std::string& name) const;
    /// "material.bed-friction = chezy"
    [[nodiscard]] std::string selected_by() const;
};
const std::vector<Law>& laws();
/// Returns an existing law.
const Law& find_law(LawKind kind, const std::string& word);
/// Returns every law of a scene; none for the structured model.
std::vector<const Law*> laws_of(const SceneSpec& scene);
/// Returns those of the given laws that read a key.
std::vector<const Law*> readers_of(const std::string& key, const std::vector<const Law*>& among);
/// The same for all laws.
std::vector<const Law*> readers_of(const std::string& key);
/// Returns the keys that select the laws: "material.bed-friction = bingham or manning or entrainment.erosion = growth".
std::string selected_by(const std::vector<const Law*>& some);
/// Returns every key that laws read, each once.
std::vector<std::string> law_keys();

/// Returns the words that select laws of a kind, between other words of their key: "voellmy", which is two laws, or
/// "off".
std::vector<std::string> law_words(const std::string& first, LawKind kind, const std::vector<std::string>& last = {});
/// Returns the words of a material's laws of bed friction, voellmy split into its two, each once.
std::vector<std::string> bed_friction_terms(const MaterialSpec& material);
/// Returns the resolved value: bingham, earth-pressure or none.
std::string in_plane_stress(const MaterialSpec& material);

}  // namespace frana
