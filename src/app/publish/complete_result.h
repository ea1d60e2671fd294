// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/input/prepare.h"
#include "app/text/run_log.h"

namespace frana::app {

/// Whether a folder holds a result that came to its end: nothing is left to be computed or written but pictures.
bool is_finished(const std::string& directory);

/// What --resume does with a finished result: draws those pictures of the scene's that are missing. Returns whether all
/// are there. Throws Error(input) where the result is of another scene.
bool complete_result(const Prepared& prepared, const std::string& directory, RunLog& log);

}  // namespace frana::app
