// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// A class and its area.
struct HazardArea {
    HazardClass kind;
    double area_m2 = 0;
};

/// Returns the scheme that a scene names; none without one.
std::optional<HazardScheme> hazard_scheme_of(const HazardSpec& spec);

/// Writes hazard.tif, hazard_zones.gpkg (one feature per class) and their styles, if the scene names a scheme; also
/// max_flux.tif and max_head.tif if they were recorded. Returns the classes' areas; none without a scheme. Throws
/// Error(environment).
std::vector<HazardArea> publish_hazard(const Prepared& prepared, const RunResult& result,
                                       const ResultDirectory& directory);

}  // namespace frana::app
