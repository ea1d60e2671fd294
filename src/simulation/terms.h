// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/words/words.h"
#include "simulation/scene.h"

namespace frana {

/// Returns the physics and numerics of a scene as sentences, for summary.json and `frana check`.
std::vector<std::string> list_terms(const Scene& scene);

/// Returns one of these in a language.

}  // namespace frana
