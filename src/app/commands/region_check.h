// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/commands/study_check.h"

namespace frana::app {

/// Prints the slopes of a region, the terrain of each, those that would fail and why, and the cost of all.
/// @param forecast of its largest slope
void print_region(const StudyInput& input, const StudyForecast& forecast, int threads, const std::string& target);

}  // namespace frana::app
