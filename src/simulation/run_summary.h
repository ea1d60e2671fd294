// SPDX-License-Identifier: Apache-2.0
// What summary.json says of a run itself; share/doc/results.md explains every key.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/ground_statistics.h"
#include "analysis/runout.h"
#include "core/json.h"
#include "params/keys/scene_spec.h"
#include "simulation/peak_statistics.h"
#include "simulation/result.h"

namespace frana {

/// Figures of the trace and of the ground under it.
struct TraceFigures {
    double threshold = 0;          ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;    ///< greatest depth above the threshold
    std::vector<Runout> run_outs;  ///< of the separate flows, the longest first; at least one
    PeakStatistics high;
    std::optional<GroundStatistics> release_ground, path_ground;  ///< of the DTM under the release and the trace
};

/// Returns the figures of a result and of the terrain, without those of the ground under the release.
/// @param threshold output.trace-threshold [m]
TraceFigures trace_figures(const RunResult& result, const Raster& terrain, double threshold);

/// Returns one word for scripts: "end-time", "still", "all-left", "requested", "reached-no-data", "non-finite".
std::string stop_word(StopReason reason);

/// How material moved when the end time was reached.
struct MotionAtEnd {
    bool front = false;    ///< the front still moved: run-out and final depth are not those of the deposit
    bool deposit = false;  ///< run-out and area had stopped changing, the deposit still crept
};
/// @param fastest greatest speed of the last step [m/s]
/// @param moving_fraction fraction of the volume that still moved
MotionAtEnd motion_at_end(bool at_end_time, double fastest, double moving_fraction, bool front_is_final) noexcept;
MotionAtEnd motion_at_end(const RunResult& result) noexcept;

/// Fraction of the volume through the edges of the computed ground from which a run-out is not the full one.
inline constexpr double k_left_ground = 1e-3;
/// Fraction of the volume that left.
double left_fraction(const RunResult& result) noexcept;
inline bool left_ground(const RunResult& result) noexcept {
    return left_fraction(result) > k_left_ground;
}

// Each adds some keys, in the order of summary.json.
void add_end(Json& json, const RunResult& result, const SceneSpec& spec);
void add_particles(Json& json, const RunResult& result);
void add_flow(Json& json, const RunResult& result, const SceneSpec& spec);
void add_trace(Json& json, const TraceFigures& trace);
void add_run_problems(Json& json, const RunResult& result);

}  // namespace frana
