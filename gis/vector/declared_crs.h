// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogrsf_frmts.h>

#include <string>

#include "gis/vector/vector_source.h"

namespace frana::gis {

/// Returns the WKT2:2019 of a layer's CRS as declared by the file; "" if it declares none. GDAL interprets a GeoJSON
/// with a "crs" that it does not understand, or that is not at the top, as degrees of WGS 84: Error(input) instead,
/// with the name.
/// @param key of the scene that overrides the file's CRS; empty: there is none
std::string declared_crs(GDALDataset& dataset, OGRLayer& layer, const VectorSource& source,
                         const std::string& key = {});

/// Returns the remedy for a file whose CRS is missing or wrong.
std::string crs_remedy(const VectorSource& source, const std::string& key = {});

}  // namespace frana::gis
