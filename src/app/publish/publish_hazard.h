// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// A class with the ground it covers.
struct HazardArea {
    HazardClass kind;
    double area_m2 = 0;
};

/// hazard.tif, hazard_zones.gpkg (one feature a class) and their styles, where the scene names a scheme;
/// further max_flux.tif and max_head.tif where they were recorded. Returns the classes' areas; none without a
/// scheme. Throws Error(environment).
std::vector<HazardArea> publish_hazard(const Prepared& prepared, const RunResult& result,
                                       const ResultDirectory& directory);

}  // namespace frana::app
