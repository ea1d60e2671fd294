// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/convergence.h"
#include "core/json.h"
#include "simulation/run_values.h"

namespace frana::app {

/// One resolution that numerics.accuracy had computed, and what it cost.
struct AccuracyLevel {
    double cell_size = 0;  ///< [m]
    std::int64_t particles = 0, steps = 0;
    double wall_seconds = 0;       ///< of the engine
    double curvature = 0;          ///< of the ground that the flow covered, on this level's terrain [1/m]
    double finest_curvature = 0;   ///< the same on the finest terrain [1/m]
    std::vector<RunValue> values;  ///< empty where `problem` is not
    std::string problem;           ///< why there are none
};

/// What numerics.accuracy decided, and why. Estimates follow from it and are not kept.
struct AccuracyRecord {
    double asked = 0;                   ///< allowed error, as a fraction of each value
    double finest_cell_size = 0;        ///< the scene's own cells, on which it would run otherwise [m]
    double terrain_cell_size = 0;       ///< the DTM's [m]
    double chosen_cell_size = 0;        ///< of the result [m]; 0: not decided yet
    std::vector<AccuracyLevel> levels;  ///< coarsest first

    [[nodiscard]] bool is_finest() const noexcept { return chosen_cell_size == finest_cell_size; }
};

/// What is known of the error of one value of the finest level computed.
struct ValueEstimate {
    RunValue value;
    GridConvergence convergence;
    double error = 0;    ///< convergence.error, and not less than the value's resolution
    double allowed = 0;  ///< error that was asked for
    /// Zero on all levels, as at a gauge that the flow came to on none: nothing is known of its error.
    bool is_zero = false;
    [[nodiscard]] bool is_within() const noexcept { return !is_zero && error <= allowed; }
    /// Of the value [%]; infinite for an error of zero.
    [[nodiscard]] double percent() const;
};

/// Of the finest of the levels that came to their end; empty where there are too few for an estimate.
std::vector<ValueEstimate> value_estimates(const AccuracyRecord& record);
/// Whether there are estimates and all are within what was asked, but for values that are zero on all levels.
bool is_reached(const std::vector<ValueEstimate>& estimates);

/// For checkpoints: the record as text and back. Throws Error(input) for a text that is none.
std::string record_text(const AccuracyRecord& record);
AccuracyRecord record_from_text(const std::string& text);

/// The member `accuracy` of summary.json.
Json accuracy_json(const AccuracyRecord& record);

/// For people: a table of the levels; a line for each value; one sentence of what is claimed, or not and why.
std::string level_table(const AccuracyRecord& record);
std::string estimate_lines(const std::vector<ValueEstimate>& estimates);
std::string accuracy_verdict(const AccuracyRecord& record);
/// "2 %"
std::string percent_text(double fraction);

}  // namespace frana::app
