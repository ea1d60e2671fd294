// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/ensemble/study_input.h"
#include "app/ensemble/study_result.h"
#include "app/publish/publish_exposure.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// The ground of which a study says something: the working grid, of a region the DTM.
Bounds computed_ground(const StudyInput& input);

/// What reaches the exposed features of a study, for its sentence.
ReachedBy exposure_reached_by(const StudyInput& input);

/// Writes what the members together do to the exposed features, if there are any: the greatest values of all; of
/// distributions the probability that the feature, not only one of its cells, is reached and exceeds each threshold; of
/// polygons how many reach it, and which is the worst.
std::optional<ExposureTotals> publish_study_exposure(const StudyInput& input, const StudyResult& result,
                                                     const Bounds& map, const ResultDirectory& directory);

}  // namespace frana::app
