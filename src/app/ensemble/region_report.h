// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/ensemble/study_input.h"
#include "app/ensemble/study_result.h"
#include "core/words/words.h"

namespace frana::app {

/// The section of a report with a region's slopes in their order: name, scenario, volume, run-out, greatest depth and
/// speed, or why a slope failed; the first k_most_slopes of them. Empty for other studies.
std::string slopes_section(const StudyInput& input, const StudyResult& result, const Words& words);

/// Slopes that a report lists; members.csv has all.
inline constexpr std::size_t k_most_slopes = 50;

}  // namespace frana::app
