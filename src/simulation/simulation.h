// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Runs a scene to its end. Same scene, same bits, for any number of threads.
/// Throws Error(input) if the scene cannot be run (nothing released, nodata under the release with its cells named). A
/// numerical failure does not throw: the result reports it in stop_reason and hard_events.
RunResult run(const Scene& scene, const RunOptions& options);

/// Returns particles, memory, first step and terms of a scene; seeds but does not run. Throws as run does.
RunEstimate estimate(const Scene& scene, int threads);

/// Returns the error of the mass balance, as a fraction of all that entered: rounding in a good run.
double relative_volume_error(const RunResult& result);

/// Returns "end time reached", "everything at rest", ...
const char* describe(StopReason reason);

}  // namespace frana
