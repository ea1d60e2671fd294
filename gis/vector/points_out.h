// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/point_table.h"

namespace frana::gis {

/// Writes a GeoPackage with one layer of points and a column of real numbers for each of the table's; NaN becomes NULL.
/// Written aside and renamed. An empty CRS is stored as undefined. Throws Error(environment).
void write_points(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& layer_name,
                  const PointTable& table);

}  // namespace frana::gis
