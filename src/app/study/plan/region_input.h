// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "app/study/plan/study_input.h"

namespace frana::app::study {

/// Reads the scene of each slope. What is wrong with some of them is kept with these; what is wrong with all is added
/// to `problems` once.
void find_problems(const std::function<SceneReading(std::size_t)>& scene_of, std::vector<Slope>& slopes,
                   Problems& problems);

/// Returns the slopes against which nothing is known, the largest first; if there are none, all.
std::vector<std::size_t> by_size(const std::vector<Slope>& slopes);

/// Prepares the slope that stands for all of a region (its material, its time, its output), the largest that can be
/// prepared, and the outlines of all. Throws Error(input) if none can be.
void prepare_region(StudyInput& input, const std::optional<Problem>& place, RunLog& log);

}  // namespace frana::app::study
