// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/scene.h"

namespace frana {

/// The physics and numerics really computed, in words, for summary.json and `frana check`.
std::vector<std::string> list_terms(const Scene& scene);

}  // namespace frana
