// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Returns a JSON Schema (2020-12) of scenes written as JSON: an object for each section, a member for each key, made
/// from the declarations. share/doc/scripts.md has the rule by which a scene file becomes JSON.
std::string scene_schema();

}  // namespace frana
