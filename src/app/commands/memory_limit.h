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

/// Applies --memory-limit, if given; see limit_memory.
void apply_memory_limit(const boost::program_options::variables_map& values, RunLog& log);

/// Throws Error(input) if a run needs more than is available. `in_use`: memory of this process with all inputs read. A
/// trial run is made only if the result depends on the flow.
void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t in_use,
                              const RunEstimate& expected, int threads);

/// The same for a run whose memory is known [bytes].
void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared);

/// Throws Error(input) if pictures that need this much besides the memory in use exceed the memory available.
void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size);

}  // namespace frana::app
