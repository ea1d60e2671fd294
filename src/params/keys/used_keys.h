// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "params/keys/parameter.h"

namespace frana {

/// Returns whether a key matters for the numbers of a scene: it was given, or the scene's model, its laws and its other
/// keys read it and it has a value, its default or one that frana chose (`is_chosen`). Keys of pictures and files
/// count only if given.
bool is_used(const SceneSpec& scene, const Parameter& key, bool is_chosen);

}  // namespace frana
