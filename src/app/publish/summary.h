// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/convergence.h"
#include "app/pictures/result_numbers.h"
#include "app/publish/publish_exposure.h"
#include "app/publish/publish_hazard.h"
#include "core/json.h"
#include "core/words/sentence.h"
#include "params/keys/scene_spec.h"
#include "simulation/result.h"
#include "simulation/run_summary.h"

namespace frana::app {

/// One resolution computed for numerics.accuracy, and its cost.
struct AccuracyLevel {
    double cell_size = 0;  ///< [m]
    std::int64_t particles = 0, steps = 0;
    double wall_seconds = 0;       ///< time of the engine
    double curvature = 0;          ///< ground_curvature under the flow, on this level's terrain [1/m]
    double finest_curvature = 0;   ///< the same on the finest terrain [1/m]
    std::vector<RunValue> values;  ///< empty if there is a `problem`
    std::string problem;           ///< reason why there are no values
};

/// The cell size chosen for numerics.accuracy and the levels it was chosen from. Estimates are computed from it, not
/// stored.
struct AccuracyRecord {
    double asked = 0;                   ///< allowed error, as a fraction of each value
    double finest_cell_size = 0;        ///< the scene's own [m]
    double terrain_cell_size = 0;       ///< the DTM's [m]
    double chosen_cell_size = 0;        ///< of the result [m]; 0: not decided yet
    std::vector<AccuracyLevel> levels;  ///< coarsest first

    [[nodiscard]] bool is_finest() const noexcept { return chosen_cell_size == finest_cell_size; }
};

/// Estimated error of one value on the finest computed level.
struct ValueEstimate {
    RunValue value;
    GridConvergence convergence;
    double error = 0;    ///< convergence.error, at least the value's resolution
    double allowed = 0;  ///< requested error
    /// Zero on all levels, for example at a gauge that the flow never reached: no estimate is possible.
    bool is_zero = false;
    [[nodiscard]] bool is_within() const noexcept { return !is_zero && error <= allowed; }
    /// Error relative to the value [%]; infinite if only the value is zero.
    [[nodiscard]] double percent() const;
};

/// Estimates for the finest completed level; empty if there are too few levels.
std::vector<ValueEstimate> value_estimates(const AccuracyRecord& record);
/// Whether there are estimates and all of them, except for values that are zero on all levels, are within the request.
bool is_reached(const std::vector<ValueEstimate>& estimates);

/// The record as text, for checkpoints, and back. Throws Error(input) for malformed text.
std::string record_text(const AccuracyRecord& record);
AccuracyRecord record_from_text(const std::string& text);

/// The member `accuracy` of summary.json.
Json accuracy_json(const AccuracyRecord& record);

/// For the terminal and the log: a table of the levels; one line per value; one sentence on the accuracy reached.
std::string level_table(const AccuracyRecord& record);
std::string estimate_lines(const std::vector<ValueEstimate>& estimates);
Sentence accuracy_verdict(const AccuracyRecord& record);
/// "2 %"
std::string percent_text(double fraction);

/// Wall time of the parts of a run [s].
struct WallSeconds {
    double total = 0, input = 0, engine = 0, output = 0, render = 0;
};

/// Content of summary.json besides the engine's own result.
struct SummaryFacts {
    SceneSpec spec;
    GridSpec computed;  ///< the scene's; rasters may cover a part of it
    std::string crs_label;
    std::string date;  ///< the day of the run, "2026-11-24"
    int threads = 1;
    WallSeconds wall;
    std::int64_t peak_memory_bytes = 0;
    MainStatistics statistics;
    PeakStatistics high;                                          ///< over that trace
    std::optional<GroundStatistics> release_ground, path_ground;  ///< of the DTM under the release and the trace
    std::optional<HazardScheme> scheme{};                         ///< of hazard
    std::vector<HazardArea> hazard;                               ///< empty: no scheme
    std::shared_ptr<const FrictionByPlace> friction;              ///< after a friction table; null without one
    std::vector<FrictionArea> friction_areas;                     ///< of the trace
    std::optional<ExposureTotals> exposure;                       ///< none: no exposed features
    Warnings warnings;                                            ///< of the result and of its writing
    std::optional<AccuracyRecord> accuracy;  ///< none: not asked for, or the run did not come to its end
    std::vector<std::string> data_identity;  ///< by which --resume compares the scene's data
};

/// Returns the part of a friction table that was chosen, and its source, for it; of no areas nothing is said.
Json friction_json(const FrictionByPlace& friction, const std::vector<FrictionArea>& areas);
/// Returns the sums over exposed features for it.
Json exposure_json(const ExposureTotals& totals);

/// Returns summary.json.
std::string summary_json(const RunResult& result, const SummaryFacts& facts);

/// Returns the peak resident memory of this process so far.
std::int64_t peak_memory_bytes();

}  // namespace frana::app
