// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/ensemble/study_result.h"

namespace frana::app {

/// Returns members.csv: a row for each member, with its values as after `--set` and its figures.
std::string members_csv(const StudyInput& input, const StudyResult& result);
/// Returns sensitivity.csv: a row for each figure and key.
std::string sensitivity_csv(const StudyInput& input, const std::vector<FigureSensitivity>& figures);

/// What a study's summary.json contains besides its members.
struct StudyFacts {
    study::MapError error;  ///< of all maps of probability
    double wall_seconds = 0;
    std::size_t computed = 0;  ///< members in this session
    int threads = 1;
    std::vector<std::string> warnings;
};
std::string study_summary_json(const StudyInput& input, const StudyResult& result, const StudyFacts& facts);

}  // namespace frana::app
