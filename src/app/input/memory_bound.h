// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/process/machine_memory.h"
#include "app/text/run_log.h"
#include "params/scene/read_scene.h"
#include "simulation/scene.h"

namespace frana::app {

/// Of a cell of a map that is read whole, though nothing reaches it: terrain, bed and their files; see forecast.cpp for
/// the memory of a whole run.
inline constexpr double k_least_cell_bytes = 40;

/// Returns the bytes of a user's limit ("4GB", "500 MB", "2GiB", bytes); logs if less is available. Throws
/// Error(input).
double memory_limit_from_text(const std::string& text, RunLog& log);

/// Returns the total memory this program may use: the least of --memory-limit, if given, and of the limits of the
/// machine, this process's control group and the shell.
MemoryBound usable_memory(const Session& session);

/// "23.5 GB, which the machine has free"
std::string bound_text(const MemoryBound& bound);

/// Throws Error(input), before any particle is made, if the grid and the release's particles alone need more than
/// available, or are more than can be numbered.
void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area);

}  // namespace frana::app
