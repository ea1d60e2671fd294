// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/study/plan/calibration_input.h"
#include "app/study/pool/member_runs.h"
#include "app/study/pool/study_result.h"
#include "app/study/statistics/calibration_posterior.h"
#include "app/study/statistics/population.h"
#include "app/text/run_log.h"

namespace frana::app::study {

/// Runs of one event, and how far they are from its survey.
struct EventRuns {
    Places places;                 ///< of the members: the design, those of the search, then draws of the posterior
    std::size_t design = 0;        ///< number of the first ones
    std::size_t searched = 0;      ///< number of those from which the posterior follows; the others forecast
    std::vector<Weight> measures;  ///< of MemberAgreement::parts
    std::vector<MemberRecord> members;
    std::vector<MemberAgreement> agreements;  ///< by member; NaN of one that failed
    double observed_runout = 0;               ///< [m]
    double pieces = 0, scatter = 0;           ///< EventSurvey::pieces() and scatter()
    std::string records;                      ///< the folder that contains their folder of records
    /// greatest_move() of the last two batches; NaN: there was one only.
    double moves[2] = {k_no_data, k_no_data};

    [[nodiscard]] bool has_settled() const noexcept { return moves[0] < k_settled && moves[1] < k_settled; }
    [[nodiscard]] bool is_stated() const noexcept { return pieces > 0; }
};

/// The runs of all events and what follows from them.
struct CalibrationRuns {
    std::vector<EventRuns> events;
    std::vector<EventModel> models;      ///< by event, of its search
    std::vector<PosteriorSample> alone;  ///< by event, of its own survey
    Population population;
    std::size_t computed = 0;  ///< runs in this session

    /// All runs of all events.
    [[nodiscard]] std::vector<MemberRecord> runs() const;
};

/// Draws of a posterior in its table.
inline constexpr std::size_t k_draws = 200;
/// How many draws of each event are run for its forecast.
inline std::size_t forecast_runs(const StudySpec& calibration) {
    return std::min(k_draws, static_cast<std::size_t>(calibration.samples));
}

/// What runs the members of a calibration.
struct RunSetting {
    std::string folder;  ///< in which the result is being built
    int threads = 1;
    bool quiet = false;
    RankPool* ranks = nullptr;  ///< the other processes under mpirun; null: none
};

/// Returns what the members of an event's search say of all places.
EventModel model_of(const StudySpec& calibration, std::size_t event, const EventRuns& runs);

/// Runs the members that have no record, event by event: first the design, then batch by batch those that
/// EventModel::next() chooses, until the posterior has settled or study.samples are run; then of each event k_draws of
/// the posterior that all events together give it, at most study.samples. Batches have max(4, members / 5) members, so
/// that bits are the same for any number of threads, and after a resume. Returns none if a signal stopped it. Throws
/// Error(numerical) if no member of an event finished, with the reason, and Error(environment).
std::optional<CalibrationRuns> run_calibration(StudyInput& input, const RunSetting& setting, RunLog& log);

}  // namespace frana::app::study
