// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/study/plan/study_input.h"

namespace frana::app::study {

/// Adds the slopes of a region with their members: one each, or with a frequency study.samples draws. Adds a problem if
/// the scene names no polygons, or they cannot be read, or no polygon has a column that the region names, or one
/// scenario has several return periods; what is wrong with a single slope is only kept with it.
void add_slopes(StudyInput& region);

/// Returns the slopes against which nothing is known, the largest first; if there are none, all.
std::vector<std::size_t> by_size(const std::vector<Slope>& slopes);

/// Prepares the slope that stands for all of a region (its material, its time, its output), the largest that can be
/// prepared, and the outlines of all. Throws Error(input) if none can be.
void prepare_region(StudyInput& input, const std::optional<Problem>& place, RunLog& log);

}  // namespace frana::app::study
