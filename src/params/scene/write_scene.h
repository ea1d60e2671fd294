// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "params/keys/scene_spec.h"

namespace frana {

/// Writes a scene as a scene file: every key with its unit and the source of its value; keys without a value as
/// comments, keys that its model does not read omitted. Reading it back gives the same scene. `resolved` adds, as a
/// comment, the values that frana chose for keys not given ("terrain.cell-size").
std::string scene_text(const SceneSpec& scene, const std::map<std::string, std::string>& resolved);

/// Returns "default", "preset", "scene file" or "command line".
std::string describe(Origin origin);

}  // namespace frana
