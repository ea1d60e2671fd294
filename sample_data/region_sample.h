// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::sample {

/// Writes slopes.geojson (EPSG:32632: four slopes on the terrain of the bindo sample, each in three scenarios) and
/// exposed.geojson (degrees: houses, a road, a camp) to an existing folder. Coordinates are rounded. Throws
/// Error(environment).
void write_region_sample(const std::string& folder);

}  // namespace frana::sample
