// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/input/prepare.h"
#include "app/text/run_log.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// Returns inputs.json of a result: each file that a key of the scene names, with its place relative to the result, its
/// absolute place at the time, and the checksum of its bytes (of files up to 1 GB). With the files beside it that
/// belong to it (shapefile, .prj, world file).
std::string recorded_inputs(const Prepared& prepared);

/// For the scene.ini of a result, which may have been moved: compares its inputs with inputs.json beside it. A file
/// that is missing is taken from its place at the time if that has the same content; another content is warned of. A
/// key that the command line sets is not compared. Throws Error(input) with every file that is missing, its key,
/// checksum and the places where it was sought.
void find_recorded_inputs(SceneReading& reading, RunLog& log);

}  // namespace frana::app
