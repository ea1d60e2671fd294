// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "analysis/high_values.h"
#include "analysis/separate_flows.h"
#include "simulation/result.h"

namespace frana {

/// Values by which studies compare runs.
struct RunStatistics {
    PeakValues depth, speed;          ///< of the maxima [m], along the bed [m/s]
    double covered_area = 0;          ///< deeper than the threshold at any time [m2]
    double run_out = 0;               ///< longest of the separate flows, straight, in map view [m]
    double final_depth_fraction = 0;  ///< fraction of the volume inside at the end that final_depth contains
};

/// One of these values, with its texts for tables.
struct RunStatistic {
    const char *key, *title, *unit;  ///< key: as in summary.json
    double (*of)(const RunStatistics&);
};

inline constexpr const char* k_run_out_key = "runout_m";
inline constexpr RunStatistic k_run_statistics[] = {
    {"max_depth_m", "maximum depth", "m", [](const RunStatistics& f) { return f.depth.greatest; }},
    {"max_depth_p999_m", "99.9 % depth", "m", [](const RunStatistics& f) { return f.depth.p999; }},
    {"max_depth_p99_m", "99 % depth", "m", [](const RunStatistics& f) { return f.depth.p99; }},
    {"max_velocity_ms", "maximum velocity", "m/s", [](const RunStatistics& f) { return f.speed.greatest; }},
    {"max_velocity_p999_ms", "99.9 % velocity", "m/s", [](const RunStatistics& f) { return f.speed.p999; }},
    {"max_velocity_p99_ms", "99 % velocity", "m/s", [](const RunStatistics& f) { return f.speed.p99; }},
    {"covered_area_m2", "covered area", "m2", [](const RunStatistics& f) { return f.covered_area; }},
    {k_run_out_key, "run-out", "m", [](const RunStatistics& f) { return f.run_out; }},
    {"final_depth_fraction", "volume in final_depth", "-",
     [](const RunStatistics& f) { return f.final_depth_fraction; }},
};

/// Whether error estimates are reported for this value; the 99 % values add nothing.
constexpr bool is_reported(const RunStatistic& statistic) {
    const std::string_view key = statistic.key;
    return key.find("_p99_") == key.npos && key != "final_depth_fraction";
}

/// @param threshold depth from which a cell belongs to the covered area [m]
/// @param inside on the result's grid: 0 excludes a cell; empty: none is excluded
RunStatistics run_statistics(const RunResult& result, double threshold, const Raster& inside = {});

/// Returns the flows of a result that never met.
SeparateFlows separate_flows(const RunResult& result);

}  // namespace frana
