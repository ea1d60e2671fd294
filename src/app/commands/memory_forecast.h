// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/commands/time_estimate.h"
#include "app/input/prepare.h"
#include "params/grammar/picture_text.h"
#include "simulation/result.h"

namespace frana::app {

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
