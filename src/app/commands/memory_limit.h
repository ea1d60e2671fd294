// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <cstdint>
#include <string>

#include "app/commands/time_estimate.h"
#include "app/input/prepare.h"
#include "app/text/run_log.h"
#include "simulation/result.h"

namespace frana::app {

/// --memory-limit, where it was given, holds from now on; see limit_memory.
void apply_memory_limit(const boost::program_options::variables_map& values, RunLog& log);

/// Throws Error(input) where a run takes more than there is. `held`: what this process held with all inputs
/// read. A trial run is made only where the run's flow decides.
void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t in_use,
                              const RunEstimate& expected, int threads);

/// The same of a run whose memory is known [bytes].
void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared);

/// Throws Error(input) where pictures that take so much beside what this process holds are more than there
/// is.
void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size);

}  // namespace frana::app
