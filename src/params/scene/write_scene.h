// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "params/keys/scene_spec.h"

namespace frana {

/// A scene as a scene file: every key with its unit and where its value came from; keys without a value as
/// comments, those that its model does not read left out. Reading it back gives the same scene. `resolved`
/// adds, for keys that were left to frana
/// ("terrain.cell-size"), what it chose, as a comment.
std::string scene_text(const SceneSpec& scene, const std::map<std::string, std::string>& resolved);

/// "default", "preset", "scene file", "command line".
std::string describe(Origin origin);

}  // namespace frana
