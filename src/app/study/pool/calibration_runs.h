// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/study/plan/calibration_input.h"
#include "app/study/pool/member_runs.h"
#include "app/study/pool/study_result.h"
#include "app/study/statistics/calibration_posterior.h"
#include "app/text/run_log.h"

namespace frana::app::study {

/// One member's run of one event.
struct MemberOutcome {
    std::string failure;        ///< empty: finished
    MemberAgreement agreement;  ///< of a finished one
    double engine_seconds = 0;
    MemberEnd end;
};

/// Runs of one event on one size of cells, and how far they are from its survey.
struct EventRuns {
    std::vector<Weight> measures;  ///< of MemberAgreement::parts
    std::vector<MemberOutcome> members;
    double cell_size = 0, observed_runout = 0;  ///< [m]
    std::string records;                        ///< the folder that contains their folder of records
};

/// Members at places in all keys, run for every event.
struct Stage {
    Places places;                    ///< independent ones
    std::vector<double> density;      ///< from which they were drawn, relative to the prior
    std::vector<SampleTable> tables;  ///< by event
    std::vector<EventRuns> events;

    [[nodiscard]] std::size_t size() const noexcept { return places.size(); }
    /// NaN where a member failed.
    [[nodiscard]] Misfits misfits() const;
    /// All runs of all events.
    [[nodiscard]] std::vector<RunOfStudy> runs() const;
    /// Number of runs that failed.
    [[nodiscard]] std::size_t failed() const;
};

/// Everything that was run.
struct CalibrationRuns {
    Stage design;                  ///< on coarse cells
    std::optional<Stage> refined;  ///< on the scenes' own; none: the design's cells are these
    std::size_t computed = 0;      ///< runs in this session

    /// The members that are the posterior.
    [[nodiscard]] const Stage& last() const noexcept { return refined ? *refined : design; }
};

/// What runs the members of a calibration.
struct RunSetting {
    std::string folder;  ///< in which the result is being built
    int threads = 1;
    bool quiet = false;
    RankPool* ranks = nullptr;  ///< the other processes under mpirun; null: none
};

/// What another rank reads of a calibration: the events on coarse cells, then on the scenes' own.
RankStudies studies_of(CalibrationInput input);

/// Compares the records of an event's members with its survey. Throws Error(environment) for one that cannot be read.
/// @param records folder that contains the folder of records
EventRuns compare_members(const CalibrationInput& input, std::size_t event, const StudyInput& members,
                          const std::string& records);

/// Runs the members that have no record: first the design on coarse cells, then those drawn where it explains the
/// surveys. Same bits for any number of threads, and after a resume. Returns none if a signal stopped it. Throws
/// Error(numerical) if no member of an event finished, with the reason, and Error(environment).
std::optional<CalibrationRuns> run_calibration(CalibrationInput& input, const RunSetting& setting, RunLog& log);

/// Returns the weights from which members on own cells are drawn: the mean of the posteriors with all events and
/// without each, of the square root of the likelihood, for coarse cells are less certain.
std::vector<double> weights_to_refine(const Misfits& misfits, double exponent);

}  // namespace frana::app::study
