// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace frana::app {

/// Throws Error(input) if the word of a command that takes a result or a raster names a scene.
inline void refuse_scene(const std::string& operand) {
    if (std::filesystem::path(operand).extension() != ".ini" || !std::filesystem::is_regular_file(operand)) return;
    throw Error(ErrorKind::input, Problem{"is a scene, not its result", "RESULT_DIR|RASTER", operand, "",
                                          "Name the folder of the result; `frana run` computes it"});
}

}  // namespace frana::app
