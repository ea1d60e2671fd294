// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "analysis/ground_statistics.h"
#include "app/input/prepare.h"
#include "app/study/plan/study_input.h"
#include "simulation/result.h"

namespace frana::app {

/// Expected wall time of a run, from a trial on larger cells.
struct TimeEstimate {
    double engine_seconds = 0;
    std::int64_t particles_peak = 0;
    double steps = 0;
    double reached_cells = 0;              ///< of the scene's size, that the trial's flow came to
    int coarsening = 1;                    ///< cells of the trial, in cells of the scene
    double trial_end = 0;                  ///< simulated time of the trial [s]
    bool cut_short = false;                ///< the trial was stopped before its end, the rest is extrapolated
    std::optional<GroundStatistics> path;  ///< the ground that the trial's flow covered
};

/// Runs the scene on cells four and eight times as large (two and four for a small release), for at most a second and a
/// half of wall time each, and extrapolates to the scene's cells. Splitting, speeds and the end of motion are those of
/// the trials: a deposit that creeps on after the trial has settled (the sample: 468 s, its trial 78 s) takes as many
/// times longer. None if the scene cannot be read on larger cells. `start`: the engine's measurement of the first
/// steps.
std::optional<TimeEstimate> estimate_time(const SceneReading& reading, const Prepared& prepared,
                                          const RunEstimate& start, int threads);

/// Wall time of computing [s]; without a trial a lower bound, from the first steps.
double engine_seconds(const RunEstimate& start, const std::optional<TimeEstimate>& trial);

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
WritingForecast forecast_study_writing(const study::StudyInput& input, const RunEstimate& member,
                                       const std::optional<TimeEstimate>& trial, int threads);
/// Of an event of `frana calibrate`.
WritingForecast forecast_event_writing(const Prepared& event, const RunEstimate& member);

}  // namespace frana::app
