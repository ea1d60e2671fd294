// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/runout.h"

namespace frana::app {

/// Values of the trace in summary.json, extent.gpkg, report.html and on every map. A run computes them once; later
/// commands read them from summary.json.
struct MainStatistics {
    double threshold = 0;        ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;  ///< of the trace: greatest depth above the threshold
    Runout run_out;              ///< if read from the file: without its places
};

/// Returns none if the result has no summary.json yet, or not these values. Throws Error(input) if the file is damaged.
std::optional<MainStatistics> read_main_statistics(const std::string& result_folder);

}  // namespace frana::app
