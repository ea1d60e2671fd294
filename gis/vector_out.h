// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"

namespace frana::gis {

struct OutlineLayer {
    std::string name;  ///< "release", "trace", "deposit"
    std::vector<PolygonFeature> features;
};

/// A GeoPackage with one multipolygon layer per entry, with an area_m2 column and the features' own
/// attributes. Written aside and renamed. An empty CRS stays unknown. Throws Error(environment).
void write_outlines(const std::string& gpkg_path, const std::string& crs_wkt,
                    const std::vector<OutlineLayer>& layers);

}  // namespace frana::gis
