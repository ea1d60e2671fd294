// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/accuracy/accuracy.h"
#include "bench/speed/speed.h"
#include "render/canvas/image.h"

namespace frana::app {

/// Draws accuracy.png: l1_depth against wall time, logarithmic, a panel for each case, both schemes; on the dam breaks
/// also GeoClaw's published values. Panels of cases with only rounding errors have a note.
render::Image accuracy_chart(const std::vector<bench::AccuracyRow>& rows);

/// Draws speed.png: particle-steps per second against particles, a panel for each flow, a line for each number of
/// threads.
render::Image speed_chart(const bench::SpeedResult& result);

}  // namespace frana::app
