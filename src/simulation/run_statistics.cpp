// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_statistics.h"

#include <cmath>

#include "analysis/runout.h"
#include "analysis/trace.h"

namespace frana {
namespace {

Raster part_inside(Raster raster, const Raster& inside) {
    for (std::size_t i = 0; i < inside.values.size(); ++i)
        if (inside.values[i] == 0) raster.values[i] = k_no_data;
    return raster;
}

}  // namespace

RunStatistics run_statistics(const RunResult& result, double threshold, const Raster& inside) {
    const Raster depth = part_inside(result.max_depth, inside);
    const Raster trace = trace_mask(depth, threshold);
    return {high_values(depth, trace), high_values(part_inside(result.max_velocity, inside), trace), masked_area(trace),
            runouts(separate_flows(result), result.bed, result.release, trace).front().horizontal_m,
            result.volume_final > 0 ? result.volume_shown / result.volume_final : k_no_data};
}

SeparateFlows separate_flows(const RunResult& result) {
    return {result.release, result.max_depth, result.inflow_places};
}

}  // namespace frana
