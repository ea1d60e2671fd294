// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/publish/publish_exposure.h"
#include "app/store/result_directory.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"

namespace frana::app::study {

/// One of several events of a region's slopes.
struct Scenario {
    std::string name, stem;    ///< stem: in names of files and columns
    double return_period = 0;  ///< [years]; 0: not known
};
/// Returns those of a region, the most frequent first.
std::vector<Scenario> scenarios_of(const StudyInput& input);

/// Warns of exposed features of which the study will say nothing.
void warn_of_unknown_exposure(const StudyInput& input, RunLog& log);

/// What reaches the exposed features of a study, for its sentence.
ReachedBy exposure_reached_by(const StudyInput& input);

/// Writes what the members together do to the exposed features, if there are any: the greatest values of all; of
/// distributions the probability that the feature, not only one of its cells, is reached and exceeds each threshold; of
/// slopes how many reach it, which is the worst, and in each scenario the class of intensity and the greatest values,
/// with the degree of hazard; of a frequency its rates.
std::optional<ExposureTotals> publish_study_exposure(const StudyInput& input, const StudyResult& result,
                                                     const Bounds& map, const ResultDirectory& directory);

}  // namespace frana::app::study
