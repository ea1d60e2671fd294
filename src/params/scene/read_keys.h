// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "params/scene/read_scene.h"

namespace frana {

/// Reads a scene without a file: its keys alone, "section.key=value", named in messages as they are. `label` stands for
/// the scene where a key is missing. `given` are keys whose data the caller has in another form.
SceneReading read_scene_keys(const std::vector<std::string>& keys, const std::vector<std::string>& given,
                             const std::string& materials_directory, const std::string& label);

/// Returns the problem of one key alone; none: read_scene_keys() takes it.
std::optional<Problem> problem_of_key(const std::string& name, const std::string& value);

}  // namespace frana
