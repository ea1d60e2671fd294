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

/// How an event is explained by a set of weights. A score is 1 - misfit: 1 agrees.
struct Explained {
    std::size_t best = 0;                  ///< member that explains the used surveys best
    double best_score = 0;                 ///< its score at this event
    double mean = 0, low = 0, high = 0;    ///< of the scores with these weights; 5 and 95 %
    double effective = 0;                  ///< effective number of members
    bool possible = false;                 ///< false: no member finished for the surveys used
    std::vector<KeyPosterior> posteriors;  ///< by key, with these weights
};

/// One event: explained with its own survey, and predicted from those of the others.
struct EventResult {
    Explained fitted, predicted;
};

/// What follows from all runs.
struct CalibrationResult {
    std::vector<double> weights;   ///< by member
    std::size_t best = 0;          ///< member with the greatest likelihood
    double effective = 0;          ///< effective number of members
    std::vector<double> q2;        ///< of the emulator of each event's misfit
    std::vector<KeySample> keys;   ///< with their values in the members
    std::vector<KeySample> after;  ///< with their values in the posterior's sample
    std::vector<double> weights_after;
    std::vector<KeyPosterior> posteriors;  ///< by key
    std::vector<IndistinctPair> indistinct;
    std::vector<EventResult> events;
    std::vector<std::vector<std::string>> uncounted;        ///< by event: measures without a stated error beside others
    std::vector<double> widening;                           ///< by event: CalibrationModel::widening()
    std::vector<Sentence> sentences;                        ///< the keys that the surveys do not tell apart
    std::vector<Sentence> doubts;                           ///< why the intervals may be wrong
    std::vector<std::optional<SchemeCheck>> scheme_checks;  ///< by event
};

/// Throws Error(numerical) if no member finished for all events.
CalibrationResult calibration_result(const StudyInput& input, const CalibrationRuns& runs);

/// Returns the name of a key in tables: with its event if others have it not.
std::string column_of(const StudySpec& calibration, const KeySample& key);

/// Writes everything that follows from the runs: tables, the best scenes, charts, report.html, summary.json. Throws
/// Error(environment), and Error(numerical) if no member finished for all events.
StudyOutcome publish_calibration(const StudyInput& input, const CalibrationRuns& runs, int threads,
                                 const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log);

/// Writes posterior_EVENT.tif for each event: the probability under the posterior that the maximum depth exceeds the
/// threshold of the survey, with its margin as second band. The map of it shows the surveyed outline and the
/// trace of the best member. A map that could not be drawn is a warning. Throws Error(environment).
void publish_calibration_maps(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const Troubles& troubles, const ResultDirectory& directory, RunLog& log);

/// Writes report.html from the tables and the charts already in the directory. Throws Error(environment).
void write_calibration_report(const StudyInput& input, const CalibrationRuns& runs, const CalibrationResult& result,
                              const StudyFacts& facts, const ResultDirectory& directory);

/// Draws the chart of a calibration, if the scene asks for any: the distribution of each key before and after. One that
/// could not be drawn is a warning.
void draw_calibration_charts(const StudyInput& input, const CalibrationResult& result, const ResultDirectory& directory,
                             RunLog& log);

}  // namespace frana::app::study
