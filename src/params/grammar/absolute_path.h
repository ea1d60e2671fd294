// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// A path as a scene says it, counted from `directory`. What GDAL puts round a path stays: a layer after '|',
/// archives ("/vsizip/tiles.zip/dtm.tif", the archive's path counted), rasters inside a file
/// (NETCDF:"file.nc":band). Connections to databases stay as they are.
std::string absolute_path(const std::string& path, const std::string& directory);

}  // namespace frana
