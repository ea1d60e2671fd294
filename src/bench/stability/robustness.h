// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/placed_scene.h"
#include "simulation/result.h"
#include "simulation/run_statistics.h"

namespace frana::bench {

/// Something that should change no value of a scene by more than its discretisation error.
struct Disturbance {
    std::string name;                    ///< "turned-90"
    std::string what;                    ///< for people
    std::vector<std::string> overrides;  ///< keys that it sets; empty: only the ground changes
    GridPlacement placement{};
    double noise = 0;            ///< standard deviation of what is added to every elevation [m]
    bool only_rounding = false;  ///< nothing but rounding may change
};

/// As it is, then everything that is tried. Noise is white from cell to cell.
std::vector<Disturbance> disturbances();

/// A scene's values under one disturbance.
struct RobustnessRow {
    Disturbance disturbance;
    std::string refusal;      ///< why it was not run; empty: it was
    std::string run_problem;  ///< what ended the run early; empty: nothing did
    RunStatistics statistics;
    double simulated_seconds = 0;
    std::int64_t steps = 0, particles = 0;
    double wall_seconds = 0;
};

struct RobustnessOptions {
    /// The scene with these keys set. Throws Error(input) where the keys are refused.
    std::function<Scene(const std::vector<std::string>& overrides)> scene;
    std::function<RunResult(const Scene&)> run;
    double threshold = 0;                            ///< depth from which a cell belongs to the covered area [m]
    std::uint64_t seed = 1;                          ///< of the noise
    std::vector<std::string> only;                   ///< names of disturbances, besides the scene as it is; empty: all
    std::function<void(const std::string&)> report;  ///< called with one line for each finished run
};

/// Runs a scene as it is and under every disturbance. All scenes are read before any is run. Where a run is
/// stopped (StopReason::requested), the rows so far, without it. Throws Error(input) for the scene as it is,
/// and for unknown names.
std::vector<RobustnessRow> run_robustness(const RobustnessOptions& options);

/// Change of a value against the scene as it is, relative to that (the first row); none where one of them
/// has none.
std::optional<double> relative_change(const std::vector<RobustnessRow>& rows, std::size_t row,
                                      const RunStatistic& statistic);
/// Changes beyond this are marked.
inline constexpr double k_robust_change = 0.05;

/// One row for each run; each value is followed by its change (key_change).
std::string robustness_csv(const std::vector<RobustnessRow>& rows);
std::string robustness_json(const std::vector<RobustnessRow>& rows, const RobustnessOptions& options,
                            const std::string& scene);
/// The line of a row in the table.
std::string robustness_line(const std::vector<RobustnessRow>& rows, std::size_t row);
std::string robustness_table(const std::vector<RobustnessRow>& rows);

}  // namespace frana::bench
