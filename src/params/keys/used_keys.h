// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/words/words.h"
#include "params/keys/parameter.h"

namespace frana {

/// Whether a key is one of the twenty that nearly every scene states or asks for: `frana new` writes them.
bool is_main_key(const std::string& name);

/// Returns where a dialogue shows a key among those that it does not hide, from 0; none: among the others.
std::optional<std::size_t> place_in_dialogue(const std::string& name);

/// Returns a key in plain words, without a capital letter: "release area", "cell size".
std::string title_of(const Parameter& key);

/// The same of the key of this name, in a language; the name itself if no scene has it.
std::string title_in(const std::string& name, const Words& words);

// What a key's declaration says, in the language of a report. Its English texts are in the catalogues.

/// Returns what a law adds to the meaning of the keys that it uses: " Used by material.bed-friction = chezy.".
std::string used_by(const std::string& key);

/// Returns the key's meaning.
std::string meaning_in(const Parameter& key, const Words& words);

/// Returns the texts of the catalogues that it and the title need, in English.
std::vector<std::string> rows_of(const Parameter& key);

/// Returns whether a key matters for the numbers of a scene: it was given, or the scene's model, its laws and its other
/// keys read it and it has a value, its default or one that frana chose (`is_chosen`). Keys of pictures and files
/// count only if given.
bool is_used(const SceneSpec& scene, const Parameter& key, bool is_chosen);

}  // namespace frana
