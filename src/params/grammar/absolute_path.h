// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Makes a path given in a scene absolute, relative to `directory`. GDAL's syntax around a path is kept: a layer after
/// '|', archives ("/vsizip/tiles.zip/dtm.tif", the archive's path made absolute), rasters inside a file
/// (NETCDF:"file.nc":band). Database connections are unchanged.
std::string absolute_path(const std::string& path, const std::string& directory);

}  // namespace frana
