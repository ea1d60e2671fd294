// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// What no key can say alone: keys that are required and keys that contradict each other. `given` holds every
/// key that was written, rightly or wrongly, so that a key with a bad value is not called missing as well.
void check_scene(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems);

}  // namespace frana
