// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/time_estimate.h"
#include "app/input/prepare.h"
#include "app/text/run_log.h"
#include "params/grammar/picture_text.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns what a command's options say for all that it reads and runs; see memory_limit_from_text.
Session session_of(const boost::program_options::variables_map& values, RunLog& log);

/// Throws Error(input) if a run needs more than is available. `in_use`: memory of this process with all inputs read. A
/// trial run is made only if the result depends on the flow.
void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t in_use,
                              const RunEstimate& expected, int threads);

/// The same for a run whose memory is known [bytes].
void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared);

/// Throws Error(input) if pictures that need this much besides the memory in use exceed the memory available.
void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size);

/// Returns the peak memory of a run, as far as a trial predicts it: libraries, inputs, engine, series, writing, drawing
/// [bytes]. An upper estimate, too large by at most about a half.
/// @param in_use memory of this process with all inputs read and nothing computed
std::int64_t memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial);

/// Returns the greatest possible memory of a run, whatever its flow: no trial is needed if that much is available
/// [bytes].
std::int64_t most_memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected);

/// Properties of pictures that affect memory.
struct Drawing {
    Size page{};  ///< of maps, views and charts; 0: none
    bool maps = true, views = false;
    Size animation{};        ///< 0: none
    std::int64_t cells = 0;  ///< of a raster
};
/// Returns its memory besides that in use by the process [bytes].
std::int64_t memory_of_drawing(const Drawing& drawing);

}  // namespace frana::app
