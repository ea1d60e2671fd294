// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// A value of a run that people use, with what its estimate of error needs to know.
struct RunValue {
    std::string key;    ///< "covered_area_m2", "gauge bridge: max_depth_m"
    std::string title;  ///< "covered area", "depth at gauge bridge"
    std::string unit;
    double value = 0;
    double resolution = 0;  ///< error that its way of measuring has in any case
    double negligible = 0;  ///< error that matters to nobody, however small the value
};

/// Those of run_statistics() that is_reported() selects; then, for each gauge, greatest depth and speed; for each
/// cross-section, greatest discharge and the volume that passed. In the same order for every run of a scene. Where
/// nothing was deeper than the threshold, values are 0. The run-out is known to a cell.
/// @param threshold depth from which a cell belongs to the covered area [m]
std::vector<RunValue> reported_values(const RunResult& result, const Scene& scene, double threshold);

}  // namespace frana
