// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/geometry.h"
#include "gis/crs/crs.h"
#include "gis/vector/vector_in.h"

namespace frana::gis::test {

/// The key that reads a release's perimeter.
inline const char* const k_where = "scene.ini: release.perimeter";

inline std::string utm() {
    return crs_from_user("EPSG:32632", "");
}

inline double total_area(const PolygonLayer& layer) {
    double sum = 0;
    for (const Feature& feature : layer.features) sum += area(feature.shape.areas);
    return sum;
}

}  // namespace frana::gis::test
