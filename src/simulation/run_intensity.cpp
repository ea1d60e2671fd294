// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_intensity.h"

namespace frana {

Raster intensity_classes(const RunResult& result, const HazardScheme& scheme) {
    // For a scheme without flux or head none is recorded; depth is passed instead and not read.
    const bool recorded = !result.max_flux.values.empty();
    return hazard_classes(scheme,
                          {result.max_depth, result.max_velocity, recorded ? result.max_flux : result.max_depth,
                           recorded ? result.max_head : result.max_depth, result.max_pressure, result.final_depth});
}

}  // namespace frana
