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

/// What a run takes at its fullest moment, as far as a trial foresees it: libraries, what was read, engine,
/// series, writing, drawing [bytes]. Rather too much than too little, by at most about a half.
/// @param held what this process holds with all inputs read and nothing computed
std::int64_t memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial);

/// What a run takes at most, whatever its flow does: no trial is needed where there is as much [bytes].
std::int64_t most_memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected);

/// What is drawn, as far as memory goes.
struct Drawing {
    Size page{};  ///< of maps, views and charts; 0: none
    bool maps = true, views = false;
    Size animation{};        ///< 0: none
    std::int64_t cells = 0;  ///< of a raster
};
/// What that takes beside what the process holds [bytes].
std::int64_t memory_of_drawing(const Drawing& drawing);

}  // namespace frana::app
