// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/words/words.h"
#include "params/keys/scene_spec.h"

namespace frana::app {

/// Replaces `auto` by the language of this process.
inline void resolve_language(SceneSpec& scene) {
    if (scene.output.language == k_language_of_locale) scene.output.language = language_code(process_language());
}

/// Returns the words of a scene's pictures and report.
inline Words words_of(const SceneSpec& scene) {
    return Words(language_of_code(scene.output.language).value_or(process_language()));
}

}  // namespace frana::app
