// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/commands/time_estimate.h"
#include "app/ensemble/study_input.h"

namespace frana::app {

/// What a command does besides computing: it reads, writes and draws.
struct WritingForecast {
    double seconds = 0;     ///< wall
    double disk_bytes = 0;  ///< of the finished result
};

/// Of `frana run`. `trial`: for the time at which the flow ends and the ground it covers; without it the run reaches
/// its end time and spreads as usual.
WritingForecast forecast_writing(const Prepared& prepared, const RunEstimate& expected,
                                 const std::optional<TimeEstimate>& trial);
/// Of `frana ensemble` and `frana batch` of a region, whose members' records are deleted at the end. Contains the
/// study's median member, which is computed again.
WritingForecast forecast_study_writing(const StudyInput& input, const RunEstimate& member,
                                       const std::optional<TimeEstimate>& trial, int threads);
/// Of an event of `frana calibrate`.
WritingForecast forecast_event_writing(const Prepared& event, const RunEstimate& member);

}  // namespace frana::app
