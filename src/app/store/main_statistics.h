// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/runout.h"
#include "app/store/run_end.h"

namespace frana::app {

/// Values of the trace in summary.json, extent.gpkg, report.html and on every map. A run computes them once; later
/// commands read them from summary.json.
struct MainStatistics {
    double threshold = 0;          ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;    ///< of the trace: greatest depth above the threshold
    std::vector<Runout> run_outs;  ///< of the separate flows, the longest first; at least one
    std::optional<RunEnd> end{};   ///< none: an older program did not tell

    [[nodiscard]] const Runout& run_out() const { return run_outs.front(); }
};

/// Returns the places from which the flows of a result come: by them flows that only flowed in are recognised.
std::vector<Point> flow_tops(const std::optional<MainStatistics>& statistics);

/// Returns none if the result has no summary.json yet, or not these values. Throws Error(input) if the file is damaged.
std::optional<MainStatistics> read_main_statistics(const std::string& result_folder);

}  // namespace frana::app
