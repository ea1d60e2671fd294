// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/process/terminal.h"
#include "app/store/result_directory.h"
#include "app/study/pool/calibration_runs.h"
#include "app/study/publish/publish_study.h"
#include "app/study/publish/scheme_check.h"

namespace frana::app::study {

/// What is known of the keys of one event, or of another slope of the same kind.
struct KeyDraws {
    std::string event;  ///< empty: another slope
    std::vector<Variation> keys;
    SampleTable sample;  ///< of their values, with weights
    std::vector<double> weights;
    std::vector<KeyPosterior> posteriors;  ///< by key
    std::vector<IndistinctPair> indistinct;
    SampleTable draws;  ///< k_draws equal ones, even among the sample
};

/// Scores at an event of values that explain surveys. A score is 1 - misfit: 1 agrees.
struct Scores {
    double mean = 0, low = 0, high = 0;  ///< 5 and 95 % of the draws
    double error = 0;                    ///< standard error of the mean
};

/// One event: with its own survey, and predicted from those of the others.
struct EventResult {
    KeyDraws after;
    std::size_t best = 0;  ///< member of its search that explains it best
    double best_score = 0;
    Scores fitted;  ///< of draws that were run
    std::optional<Scores> predicted;
    std::vector<KeyPosterior> predicted_keys;  ///< shared ones, from the surveys of the others
    std::vector<std::string> uncounted;        ///< measures without a stated error beside others
    std::optional<SchemeCheck> scheme_check;
};

/// What follows from all runs.
struct CalibrationResult {
    std::vector<EventResult> events;
    KeyDraws next;                   ///< another slope
    std::vector<StudyDoubt> doubts;  ///< why the intervals may be wrong
    std::optional<Sentence> spread;  ///< what that of the slopes rests on if the events say nothing of it
};

/// The keys of all events, each once.
std::vector<Variation> keys_of(const StudySpec& calibration);

CalibrationResult calibration_result(const StudyInput& input, const CalibrationRuns& runs);

/// Writes everything that follows from the runs: tables, the best scenes, charts, report.html, summary.json. Throws
/// Error(environment).
StudyOutcome publish_calibration(const StudyInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log);

/// Writes posterior_EVENT.tif for each event: the probability that the maximum depth exceeds the threshold of the
/// survey if it happens again, of the draws that were run, with its margin as second band. The map of it shows the
/// surveyed outline and the trace of the best member. A map that could not be drawn is a warning. Throws
/// Error(environment).
void publish_calibration_maps(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const Troubles& troubles, const ResultDirectory& directory, Findings found);

/// Writes report.html from the tables and the charts already in the directory. Throws Error(environment).
void write_calibration_report(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const StudyFacts& facts, const ResultDirectory& directory);

/// Draws the chart of a calibration, if the scene asks for any: the distribution of each key before and after. One that
/// could not be drawn is a warning.
void draw_calibration_charts(const StudyInput& input, const CalibrationResult& result, const ResultDirectory& directory,
                             Findings found);

}  // namespace frana::app::study
