// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/program_options/variables_map.hpp>
#include <cstdint>
#include <optional>

#include "app/prepare.h"
#include "app/time_estimate.h"
#include "simulation/result.h"

namespace frana::app {

/// --memory-limit ("4GB", "500 MB", "2GiB", bytes), which holds from now on. Throws Error(input).
void take_memory_limit(const boost::program_options::variables_map& values);

/// What this program may use [bytes]: the machine's memory, or less where the shell or --memory-limit set a limit.
double usable_memory();

/// Whether --memory-limit was given.
bool memory_is_limited();

/// What a run takes at its fullest moment, as far as a trial foresees it: libraries, reading, engine, writing, drawing
/// [bytes].
std::int64_t memory_of_run(const Prepared& prepared, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial);

/// Throws Error(input), before any particle is made, where the grid and the release's particles alone take more than
/// there is, or are more than can be numbered.
void refuse_too_much(const SceneReading& reading, const Scene& scene, double released_area);

/// Throws Error(input) where a run would take more than --memory-limit allows.
void refuse_over_limit(std::int64_t needed);

}  // namespace frana::app
