// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "params/keys/parameter.h"

namespace frana {

/// Returns every key of a scene file, in the order of the documentation and the echo.
const std::vector<Parameter>& scene_parameters();

/// The sections in order, each with a title for dialogues and one sentence.
struct Section {
    std::string name;
    std::string title;
    std::string meaning;
};
std::vector<Section> scene_sections();

}  // namespace frana
