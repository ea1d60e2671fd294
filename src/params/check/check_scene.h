// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Checks conditions on several keys: required keys and contradictions between keys. `given` contains every key present
/// in the input, valid or not, so that a key with an invalid value is not also reported as missing.
void check_scene(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems);

}  // namespace frana
