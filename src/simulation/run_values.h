// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "core/words/words.h"
#include "params/keys/result_rasters.h"
#include "simulation/result.h"
#include "simulation/scene.h"

namespace frana {

/// Returns the class of intensity of every cell that a run reached, NaN elsewhere.
Raster intensity_classes(const RunResult& result, const HazardScheme& scheme);

/// A value of a run whose error numerics.accuracy estimates.
struct RunValue {
    std::string key;    ///< "covered_area_m2", "gauge bridge: max_depth_m"
    std::string title;  ///< "covered area", "depth at gauge bridge"
    std::string unit;
    double value = 0;
    double resolution = 0;  ///< error of its measurement, whatever the cell size's convergence
    double negligible = 0;  ///< absolute error that is always acceptable
};

/// Values of run_statistics() selected by is_reported(); then greatest depth and speed for each gauge; greatest
/// discharge and volume for each cross-section. Same order for every run of a scene. All 0 if nothing was deeper than
/// the threshold. The resolution of the run-out is one cell.
/// @param threshold depth from which a cell belongs to the covered area [m]
std::vector<RunValue> reported_values(const RunResult& result, const Scene& scene, double threshold);

/// Whether a key is that of a value which some run may have.
bool is_value_key(const std::string& key);

/// Returns the value's title in a language.
std::string title_in(const RunValue& value, const Words& words);

}  // namespace frana
