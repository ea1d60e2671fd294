// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <cstdint>
#include <string>

#include "app/machine_memory.h"
#include "app/prepare.h"
#include "app/run_log.h"
#include "app/time_estimate.h"
#include "simulation/result.h"

namespace frana::app {

/// --memory-limit ("4GB", "500 MB", "2GiB", bytes), which holds from now on; told where there is not as much.
/// Throws Error(input).
void take_memory_limit(const boost::program_options::variables_map& values, RunLog& log);

/// What this program may hold in all: the least of --memory-limit, where it was given, and of what the
/// machine, this process's control group and the shell leave it.
MemoryBound usable_memory();

/// Throws Error(input), before any particle is made, where the grid and the release's particles alone take
/// more than there is, or are more than can be numbered.
void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area);

/// Throws Error(input) where a run takes more than there is. `held`: what this process held with all inputs
/// read. A trial run is made only where the run's flow decides.
void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t held,
                              const RunEstimate& expected, int threads);

/// The same of a run whose memory is known [bytes].
void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared);

/// Throws Error(input) where pictures that take so much beside what this process holds are more than there
/// is.
void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size);

}  // namespace frana::app
