// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "analysis/hazard.h"
#include "simulation/result.h"

namespace frana {

/// Returns the class of intensity of every cell that a run reached, NaN elsewhere.
Raster intensity_classes(const RunResult& result, const HazardScheme& scheme);

}  // namespace frana
