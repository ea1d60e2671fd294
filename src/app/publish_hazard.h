// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "app/map_source.h"
#include "app/prepare.h"
#include "app/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// A class with the ground it covers.
struct HazardArea {
    HazardClass kind;
    double area_m2 = 0;
};

/// What a scheme made of a run; without a scheme, no areas.
struct HazardResult {
    std::vector<HazardArea> areas;
    Raster classes;
};

/// hazard.tif, hazard_zones.gpkg (one feature a class) and their styles, where the scene names a scheme;
/// further max_flux.tif and max_head.tif where they were recorded. Throws Error(environment).
HazardResult publish_hazard(const Prepared& prepared, const RunResult& result,
                            const ResultDirectory& directory);

/// The classes as a map.
void draw_hazard(const HazardResult& hazard, MapSource source, const std::string& path);

}  // namespace frana::app
