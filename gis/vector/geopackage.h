// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

class GDALDataset;
class OGRSpatialReference;

namespace frana::gis {

/// Creates a GeoPackage aside, fills it by `write_layers(dataset, crs)`, which returns false on failure, and renames
/// it. An empty CRS becomes GeoPackage's undefined Cartesian one. Throws Error(environment).
void write_geopackage(const std::string& gpkg_path, const std::string& crs_wkt,
                      const std::function<bool(GDALDataset&, OGRSpatialReference*)>& write_layers);

}  // namespace frana::gis
