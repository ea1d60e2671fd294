// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "app/ensemble/study_input.h"
#include "app/process/stopwatch.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// What was done before a study is written.
struct FinishedStudy {
    StudyInput& input;
    std::size_t members;   ///< that ran
    std::size_t computed;  ///< of these in this session
    int threads;
    const Stopwatch& since_start;
};

struct StudyOutcome {
    bool too_many_failed = false;
    bool pictures_failed = false;
    bool has_troubles = false;  ///< Troubles::any
};

/// Writes everything that follows from the members' records in the directory: rasters, tables, outlines, maps, charts,
/// report.html, summary.json. Throws Error(environment).
StudyOutcome publish_study(const FinishedStudy& study, const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app
