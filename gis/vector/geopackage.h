// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gis/vector/vector_style.h"

class GDALDataset;
class OGRSpatialReference;

namespace frana::gis {

/// Creates a GeoPackage aside, fills it by `write_layers(dataset, crs)`, which returns false on failure, and renames
/// it. An empty CRS becomes GeoPackage's undefined Cartesian one. Throws Error(environment).
void write_geopackage(const std::string& gpkg_path, const std::string& crs_wkt,
                      const std::function<bool(GDALDataset&, OGRSpatialReference*)>& write_layers);

/// The style of a layer.
struct LayerStyle {
    std::string layer;
    StyleText style;
};

/// Name of QGIS's table of styles, which is no layer.
inline constexpr const char* k_style_table = "layer_styles";

/// Adds QGIS's table of styles, each the default of its layer. Returns false on failure.
bool write_layer_styles(GDALDataset& dataset, const std::vector<LayerStyle>& styles);

}  // namespace frana::gis
