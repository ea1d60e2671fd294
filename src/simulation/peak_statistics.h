// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "analysis/high_values.h"
#include "core/words/words.h"
#include "simulation/raster_of_row.h"

namespace frana {

/// A raster of maxima whose high values are reported: in summary.json (keys NAME_UNIT, NAME_p999_UNIT, NAME_p99_UNIT),
/// in the report, and in studies.
struct PeakStatistic {
    const char *name, *key_unit;  ///< "max_depth", "m"
    const char* title;            ///< "depth, vertical"

    /// Its row in the table of rasters.
    [[nodiscard]] const ResultRaster& row() const { return *find_result_raster(name); }
};

inline constexpr std::array<PeakStatistic, 3> k_peak_statistics{{
    {"max_depth", "m", worded("depth, vertical")},
    {"max_velocity", "ms", worded("speed, along the ground")},
    {"max_pressure", "kpa", worded("dynamic pressure")},
}};

/// One for each value, over the cells of a trace.
using PeakStatistics = std::array<PeakValues, k_peak_statistics.size()>;

inline PeakStatistics peak_statistics(const RunResult& result, const Raster& trace) {
    PeakStatistics high;
    for (std::size_t i = 0; i < high.size(); ++i)
        high[i] = high_values(*raster_of_row(result, k_peak_statistics[i].row()), trace);
    return high;
}

}  // namespace frana
