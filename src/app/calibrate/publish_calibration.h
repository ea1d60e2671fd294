// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/calibrate/calibration_result.h"
#include "app/ensemble/publish_study.h"
#include "app/process/stopwatch.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// Loads what the maps and charts are drawn with, before anything runs. Throws Error(environment) if it is missing.
void load_calibration_drawing(const CalibrationInput& input);

/// Writes everything that follows from the runs: tables, the best scenes, charts, report.html, summary.json. Throws
/// Error(environment), and Error(numerical) if no member finished for all events.
StudyOutcome publish_calibration(const CalibrationInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app
