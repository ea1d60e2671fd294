// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/text/run_log.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana::app {

inline constexpr double k_thin_fraction =
    0.1;  ///< of the volume that may be thinner than maps or outlines show without a word

/// Warns, before anything is computed, of a release of which maps and values, or outlines and run-out, do
/// not show a good part.
void warn_of_thin_release(const RunEstimate& expected, const Scene& scene, RunLog& log);

}  // namespace frana::app
