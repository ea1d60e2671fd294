// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/process/machine_memory.h"
#include "app/text/run_log.h"
#include "params/scene/read_scene.h"
#include "simulation/scene.h"

namespace frana::app {

/// A limit of the user's ("4GB", "500 MB", "2GiB", bytes), which holds from now on; told where there is not as much.
/// Throws Error(input).
void limit_memory(const std::string& text, RunLog& log);

/// What this program may hold in all: the least of --memory-limit, where it was given, and of what the
/// machine, this process's control group and the shell leave it.
MemoryBound usable_memory();

/// "23.5 GB, which the machine has free"
std::string bound_text(const MemoryBound& bound);

/// Throws Error(input), before any particle is made, where the grid and the release's particles alone take
/// more than there is, or are more than can be numbered.
void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area);

}  // namespace frana::app
