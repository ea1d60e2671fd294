// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/scene.h"

namespace frana {

/// Returns the physics and numerics of a scene as sentences, for summary.json and `frana check`.
std::vector<std::string> list_terms(const Scene& scene);

}  // namespace frana
