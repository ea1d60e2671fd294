// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "params/keys/scene_spec.h"
#include "physics/law.h"

namespace frana {

struct PorePressure;

/// Returns whether the model of a scene reads a key.
bool model_reads(const SceneSpec& scene, const std::string& name);

/// Returns whether solids of the structured model read a key of pore pressure: [structured] has some of its own.
bool solids_read(const std::string& name);

/// Reports keys of the scene that its model does not read, and keys that the structured model requires or does not
/// support.
/// @param given names given in the file or on the command line  @param file for messages
void check_model(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems);

/// Returns the rows of src/physics/laws.h, each with the keys that the law brings with it.
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
std::vector<std::string> bed_friction_terms(const Material& material);
/// Returns the resolved value: the word of a law, or none.
std::string in_plane_stress(const Material& material);
/// Returns tan(phi) of bed friction; nothing if no key gives it.
std::optional<double> friction_coefficient_of(const Material& material);
/// Returns the law of pore pressure with the values of its keys.
PorePressure pore_pressure_of(const Material& material);

}  // namespace frana
