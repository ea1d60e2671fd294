// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/ground_statistics.h"
#include "app/commands/command_line.h"
#include "app/input/prepare.h"
#include "app/study/plan/study_input.h"
#include "app/text/run_log.h"
#include "core/error.h"
#include "params/grammar/value_text.h"
#include "simulation/result.h"

namespace frana::app {

/// Expected wall time of a run, from a trial on larger cells.
struct TimeEstimate {
    double engine_seconds = 0;
    std::int64_t particles_peak = 0;
    double steps = 0;
    int coarsening = 1;                    ///< cells of the trial, in cells of the scene
    double trial_end = 0;                  ///< simulated time of the trial [s]
    bool cut_short = false;                ///< the trial was stopped before its end, the rest is extrapolated
    std::optional<GroundStatistics> path;  ///< the ground that the trial's flow covered
    double left = 0;                       ///< fraction of the trial's volume that left the ground
    bool meets_gap = false;                ///< whether ground without elevation ended the trial
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

/// The time of a scene by one of the schemes.
struct SchemeTime {
    std::string scheme;           ///< "finite-volume"
    std::string refusal;          ///< why the scene cannot be computed by it; empty: it can
    double engine_seconds = 0;    ///< wall time of computing, estimated on this machine [s]
    bool is_lower_bound = false;  ///< no trial was possible
};
/// Estimates that of a scene read with the scheme.
SchemeTime scheme_time(const SceneReading& reading, int threads);

/// Returns what a command's options say for all that it reads and runs; see memory_limit_from_text.
Session session_of(const Options& values, RunLog& log);

/// Throws Error(input) if a run needs more than is available. `in_use`: memory of this process with all inputs read. A
/// trial run is made only if the result depends on the flow.
void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t in_use,
                              const RunEstimate& expected, int threads);

/// The same for a run whose memory is known [bytes].
void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared);

/// Throws Error(input) if pictures that need this much besides the memory in use exceed the memory available.
void refuse_pictures_of(std::int64_t needed, const Place& where, const std::string& size);

/// Returns the peak memory of a run, as far as a trial predicts it: libraries, inputs, engine, series, writing, drawing
/// [bytes]. An upper estimate, too large by at most about a half.
/// @param in_use memory of this process with all inputs read and nothing computed
std::int64_t memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial);

/// Returns the greatest possible memory of a run, whatever its flow: no trial is needed if that much is available
/// [bytes].
std::int64_t most_memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected);

/// Properties of pictures that affect memory.
struct Drawing {
    Size page{};  ///< of maps, views and charts; 0: none
    bool maps = true, views = false;
    Size animation{};        ///< 0: none
    std::int64_t cells = 0;  ///< of a raster
};
/// Returns its memory besides that in use by the process [bytes].
std::int64_t memory_of_drawing(const Drawing& drawing);

}  // namespace frana::app
