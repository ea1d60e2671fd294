// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "analysis/runout.h"

namespace frana {

/// Values of the trace in summary.json, extent.gpkg, report.html and on every map. A run computes them once; later
/// commands read them from summary.json.
struct MainStatistics {
    double threshold = 0;          ///< output.trace-threshold: depth that counts as covered [m]
    double covered_area_m2 = 0;    ///< of the trace: greatest depth above the threshold
    std::vector<Runout> run_outs;  ///< of the separate flows, the longest first; at least one

    [[nodiscard]] const Runout& run_out() const { return run_outs.front(); }
};

}  // namespace frana
