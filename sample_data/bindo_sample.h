// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana::sample {

/// Writes dtm.tif, thickness.tif (EPSG:32632), perimeter.shp (EPSG:4326) and scar.shp (EPSG:3003) to an existing
/// folder. Values are rounded (heights to 1 cm, coordinates to 1e-9 degrees or 1 mm), so that the files do not depend
/// on the last bits of a machine's mathematics. Throws Error(environment).
void write_bindo_sample(const std::string& folder);

}  // namespace frana::sample
