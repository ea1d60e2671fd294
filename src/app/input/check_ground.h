// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/ground_statistics.h"
#include "app/text/run_log.h"
#include "simulation/scene.h"

namespace frana::app {

/// Returns "412 to 780 m, slope 27 degrees on average, 51 at most".
Sentence ground_sentence(const GroundStatistics& ground);

/// Statistics of the DTM under the outlines of the release; none if nothing is released.
std::optional<GroundStatistics> ground_of_release(const Scene& scene);

/// Warns of ground on which landslides do not start, or over which they do not move: steeper or flatter than in nature
/// where elevations are in another unit than eastings, or the layers do not belong together.
void warn_of_release_ground(const GroundStatistics& ground, RunLog& log);
void warn_of_path_ground(const GroundStatistics& ground, RunLog& log);

}  // namespace frana::app
