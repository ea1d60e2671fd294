// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/process/stopwatch.h"
#include "app/store/result_directory.h"
#include "app/study/publish/calibration_result.h"
#include "app/study/publish/publish_study.h"

namespace frana::app::study {

/// Returns posterior.csv: a row for each member of the last stage with its weight, score, values and misfits. A column
/// of a shared key has the key's name, so that `frana ensemble` takes the file with sampling = table:FILE.
std::string posterior_csv(const CalibrationInput& input, const CalibrationRuns& runs, const CalibrationResult& result);
/// The same for one event that has keys of its own: all its keys by their names.
std::string event_posterior_csv(const CalibrationRuns& runs, const CalibrationResult& result, std::size_t event);
/// Returns design.csv: the same columns, without weights, of the members on coarse cells.
std::string design_csv(const CalibrationInput& input, const CalibrationRuns& runs);

/// Returns calibration.json: best values, intervals, scores by event, fitted and predicted. No wall time is in it.
std::string calibration_json(const CalibrationInput& input, const CalibrationRuns& runs,
                             const CalibrationResult& result);

/// What a calibration cost.
struct CalibrationFacts {
    Troubles troubles;
    double wall_seconds = 0;
    int threads = 1;
    std::vector<Sentence> warnings;
    std::string date;  ///< the day it was written, "2026-11-24"
};
/// Returns summary.json.
std::string calibration_summary_json(const CalibrationInput& input, const CalibrationRuns& runs,
                                     const CalibrationFacts& facts);

/// Returns the names and values of the best member for one event, as after `--set`.
std::vector<std::string> best_values(const CalibrationRuns& runs, const CalibrationResult& result, std::size_t event);

/// Loads what the maps and charts are drawn with, before anything runs. Throws Error(environment) if it is missing.
void load_calibration_drawing(const CalibrationInput& input);

/// Writes everything that follows from the runs: tables, the best scenes, charts, report.html, summary.json. Throws
/// Error(environment), and Error(numerical) if no member finished for all events.
StudyOutcome publish_calibration(const CalibrationInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app::study
