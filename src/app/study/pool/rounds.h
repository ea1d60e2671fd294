// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"

namespace frana::app::study {

/// Runs a study by importance sampling: each round follows from the runs of those before (ImportanceSampling), with
/// their distances from the study's rare place. Returns false if it was stopped.
bool run_importance(StudyInput& input, const std::string& folder, const std::function<bool(std::size_t)>& run_until);

}  // namespace frana::app::study
