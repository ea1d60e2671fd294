// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "core/error.h"
#include "params/keys/scene_spec.h"

namespace frana {

/// Checks that the laws of [material] and [entrainment] have the keys they need and that no given key is unread by
/// every law.
void check_laws(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                Problems& problems);

}  // namespace frana
