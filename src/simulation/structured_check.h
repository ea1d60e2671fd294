// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/error.h"
#include "simulation/scene.h"

namespace frana {

/// Returns the problems of a structured material: values that its laws do not describe.
/// @param where returns where a key was given, for messages
std::vector<Problem> structured_problems(const StructuredMaterial& material,
                                         const std::function<std::string(const std::string&)>& where);

}  // namespace frana
