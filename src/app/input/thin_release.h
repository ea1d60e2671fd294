// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana::app {

inline constexpr double k_thin_fraction =
    0.1;  ///< fraction of the volume that may be thinner than visible on maps or in outlines without a warning

/// Warns, before anything is computed, if maps and values, or outlines and run-out, omit a substantial part of a
/// release.
void warn_of_thin_release(const RunEstimate& expected, const Scene& scene, RunLog& log);

}  // namespace frana::app
