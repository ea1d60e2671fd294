// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/words/words.h"
#include "params/keys/parameter.h"

namespace frana {

// What a key's declaration says, in the language of a report. Its English texts are in the catalogues.

/// Returns what a law adds to the meaning of the keys that it uses: " Used by material.bed-friction = chezy.".
std::string used_by(const std::string& key);

/// Returns the key's meaning.
std::string meaning_in(const Parameter& key, const Words& words);
/// Returns the effect if the key is not given.
std::string absent_in(const Parameter& key, const Words& words);

/// Returns the texts of the catalogues that these two need, in English.
std::vector<std::string> rows_of(const Parameter& key);

}  // namespace frana
