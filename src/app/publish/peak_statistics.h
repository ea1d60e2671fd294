// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "analysis/high_values.h"
#include "simulation/result.h"

namespace frana::app {

/// A raster of maxima whose high values are reported: in summary.json (keys NAME_UNIT, NAME_p999_UNIT, NAME_p99_UNIT),
/// in the report, and in studies.
struct PeakStatistic {
    const char *name, *key_unit;  ///< "max_depth", "m"
    const char *title, *unit;     ///< "depth, vertical", "m"
    Raster RunResult::*values;
};

inline constexpr std::array<PeakStatistic, 3> k_peak_statistics{{
    {"max_depth", "m", "depth, vertical", "m", &RunResult::max_depth},
    {"max_velocity", "ms", "speed, along the ground", "m/s", &RunResult::max_velocity},
    {"max_pressure", "kpa", "dynamic pressure", "kPa", &RunResult::max_pressure},
}};

/// One for each value, over the cells of a trace.
using PeakStatistics = std::array<PeakValues, k_peak_statistics.size()>;

inline PeakStatistics peak_statistics(const RunResult& result, const Raster& trace) {
    PeakStatistics high;
    for (std::size_t i = 0; i < high.size(); ++i) high[i] = high_values(result.*k_peak_statistics[i].values, trace);
    return high;
}

}  // namespace frana::app
