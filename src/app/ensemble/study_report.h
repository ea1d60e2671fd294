// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/ensemble/study_tables.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// Writes report.html of a study from its tables and the pictures already in its directory: one self-contained file.
/// Throws Error(environment).
void write_study_report(const StudyInput& input, const StudyResult& result,
                        const std::vector<FigureSensitivity>& figures, const StudyFacts& facts,
                        const ResultDirectory& directory);

}  // namespace frana::app
