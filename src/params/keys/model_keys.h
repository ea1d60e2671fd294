// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Returns whether the model of a scene reads a key.
bool model_reads(const SceneSpec& scene, const std::string& name);

/// Reports keys of the scene that its model does not read, and keys that the structured model requires or does not
/// support.
/// @param given names given in the file or on the command line  @param file for messages
void check_model(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems);

}  // namespace frana
