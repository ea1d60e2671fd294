// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/commands/forecast.h"
#include "app/study/plan/study_input.h"
#include "app/text/run_log.h"
#include "core/json.h"
#include "params/keys/scene_spec.h"

namespace frana::app {

/// Prints the density with its origin, and the keys whose default decides a number on the map.
void print_defaults(const Prepared& prepared);
/// Adds the same to the document of --json.
void add_defaults(const Prepared& prepared, Json& json);

/// Prints where the result goes, and whether there is one.
void print_result(const std::string& directory);
/// The same for the document of --json.
Json result_json(const std::string& directory);

/// Expected resources of a study.
struct StudyForecast {
    RunEstimate member;                 ///< the central one
    std::optional<TimeEstimate> trial;  ///< of its time, on one thread
    std::int64_t worker_bytes = 0;      ///< memory of one member that runs
    std::int64_t peak_bytes = 0;        ///< memory of all together, and of combining them

    /// Wall time of one member on one thread [s]; a lower bound without a trial.
    [[nodiscard]] double member_seconds() const noexcept;
};

/// @param with_trial also makes a trial run, for time and memory
StudyForecast forecast_study(const study::StudyInput& input, int threads, bool with_trial);

/// Throws Error(input) if so many members at once need more memory than there is.
/// @param processes on this machine, each with so many threads
void refuse_study_beyond_memory(const study::StudyInput& input, const StudyForecast& forecast, int threads,
                                int processes = 1);

/// Returns where a study's result goes without --out: beside that of its scene.
std::string study_directory(const study::StudySpec& study, const SceneSpec& scene);

/// `frana check` of a study of any kind: with `print`, prints keys, members and forecasts to stdout; returns the
/// document of --json. Throws Error(input).
Json check_study(const std::string& path, study::StudyKind kind, const std::optional<std::string>& out, int threads,
                 bool print, const Session& session, RunLog& log);

}  // namespace frana::app
