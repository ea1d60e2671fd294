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

/// Runs of one event, and how far they are from its survey.
struct EventRuns {
    std::vector<Weight> measures;  ///< of MemberAgreement::parts
    std::vector<MemberRecord> members;
    std::vector<MemberAgreement> agreements;  ///< by member; NaN of one that failed
    double observed_runout = 0;               ///< [m]
    double pieces = 0;                        ///< EventSurvey::pieces()
    std::string records;                      ///< the folder that contains their folder of records
};

/// Members at places in all keys, run for every event.
struct CalibrationRuns {
    Places places;  ///< independent ones; the first are the design
    std::vector<EventRuns> events;
    std::size_t design = 0;
    std::size_t computed = 0;  ///< runs in this session
    /// greatest_move() of the last two batches; NaN: there was one only.
    double moves[2] = {k_no_data, k_no_data};

    [[nodiscard]] std::size_t size() const noexcept { return places.size(); }
    [[nodiscard]] bool has_settled() const noexcept { return moves[0] < k_settled && moves[1] < k_settled; }
    /// By member and event; NaN where a member failed.
    [[nodiscard]] std::vector<std::vector<double>> misfits() const;
    /// All runs of all events.
    [[nodiscard]] std::vector<MemberRecord> runs() const;
};

/// What runs the members of a calibration.
struct RunSetting {
    std::string folder;  ///< in which the result is being built
    int threads = 1;
    bool quiet = false;
    RankPool* ranks = nullptr;  ///< the other processes under mpirun; null: none
};

/// Returns what the members say of all places.
CalibrationModel model_of(const StudySpec& calibration, const CalibrationRuns& runs);

/// Runs the members that have no record: first the design, then batch by batch those that CalibrationModel::next()
/// chooses, until the posterior has settled or study.samples are run. Batches have max(4, members / 5) members, so that
/// bits are the same for any number of threads, and after a resume. Returns none if a signal stopped it. Throws
/// Error(numerical) if no member of an event finished, with the reason, and Error(environment).
std::optional<CalibrationRuns> run_calibration(StudyInput& input, const RunSetting& setting, RunLog& log);

}  // namespace frana::app::study
