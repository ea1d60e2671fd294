// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "analysis/runout.h"

namespace frana::app {

/// Values of the trace that summary.json, extent.gpkg, report.html and every map show. A run computes them once; all
/// who come later read them from summary.json.
struct MainStatistics {
    double threshold = 0;        ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;  ///< of the trace: greatest depth over the threshold
    Runout run_out;              ///< read back: without its places
};

/// None where the result has no summary.json yet, or not these values. Throws Error(input) where the file is
/// damaged.
std::optional<MainStatistics> read_main_statistics(const std::string& result_folder);

}  // namespace frana::app
