// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/input/prepare.h"
#include "app/text/run_log.h"

namespace frana::app {

/// Returns whether a folder contains a complete result: nothing remains to be computed or written except pictures.
bool is_finished(const std::string& directory);

/// Implements --resume for a complete result: draws the scene's missing pictures. Returns whether all exist. Throws
/// Error(input) if the result is of another scene.
bool complete_result(const Prepared& prepared, const std::string& directory, RunLog& log);

}  // namespace frana::app
