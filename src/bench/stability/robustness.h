// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/placed_scene.h"
#include "simulation/result.h"
#include "simulation/run_summary.h"

namespace frana::bench {

/// A change that must not change any value of a scene by more than its discretisation error.
struct Disturbance {
    std::string name;                    ///< "turned-90"
    std::string what;                    ///< for messages
    std::vector<std::string> overrides;  ///< keys that it sets; empty: only the ground changes
    GridPlacement placement{};
    double noise = 0;            ///< standard deviation of what is added to every elevation [m]
    bool only_rounding = false;  ///< nothing but rounding may change
};

/// Returns the unchanged scene, then every disturbance. Noise is uncorrelated between cells.
std::vector<Disturbance> disturbances();

/// A scene's values under one disturbance.
struct RobustnessRow {
    Disturbance disturbance;
    std::string refusal;      ///< reason why it was not run; empty: it was
    std::string run_problem;  ///< what ended the run early; empty: nothing did
    RunStatistics statistics;
    double simulated_seconds = 0;
    std::int64_t steps = 0, particles = 0;
    double wall_seconds = 0;
};

struct RobustnessOptions {
    /// Returns the scene with these keys set. Throws Error(input) if the keys are refused.
    std::function<Scene(const std::vector<std::string>& overrides)> scene;
    std::function<RunResult(const Scene&)> run;
    double threshold = 0;                            ///< depth from which a cell belongs to the covered area [m]
    std::uint64_t seed = 1;                          ///< of the noise
    std::vector<std::string> only;                   ///< names of disturbances, besides the unchanged scene; empty: all
    std::function<void(const std::string&)> report;  ///< called with one line for each finished run
};

/// Runs a scene unchanged and under every disturbance. All scenes are read before any is run. If a run is stopped
/// (StopReason::requested), returns the rows so far, without it. Throws Error(input) for the unchanged scene, and for
/// unknown names.
std::vector<RobustnessRow> run_robustness(const RobustnessOptions& options);

/// Returns the relative change of a value against the unchanged scene (the first row); none if either has none.
std::optional<double> relative_change(const std::vector<RobustnessRow>& rows, std::size_t row,
                                      const RunStatistic& statistic);
/// Greater changes are marked.
inline constexpr double k_robust_change = 0.05;

/// Returns one row for each run; each value is followed by its change (key_change).
std::string robustness_csv(const std::vector<RobustnessRow>& rows);
std::string robustness_json(const std::vector<RobustnessRow>& rows, const RobustnessOptions& options,
                            const std::string& scene);
/// Returns the line of a row in the table.
std::string robustness_line(const std::vector<RobustnessRow>& rows, std::size_t row);
std::string robustness_table(const std::vector<RobustnessRow>& rows);

}  // namespace frana::bench
