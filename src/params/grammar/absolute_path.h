// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace frana {

/// Makes a path given in a scene absolute, relative to `directory`. GDAL's syntax around a path is kept: a layer after
/// '|', archives ("/vsizip/tiles.zip/dtm.tif", the archive's path made absolute), rasters inside a file
/// (NETCDF:"file.nc":band). Database connections are unchanged.
std::string absolute_path(const std::string& path, const std::string& directory);

/// Returns an absolute path relative to a directory, by which a file in that directory names it; GDAL's syntax is kept
/// as above. Unchanged if the relative path would not lead to the same file (through a symbolic link).
std::string relative_path(const std::string& path, const std::string& directory);

/// Returns the file of the file system that such a path names: "/data/tiles.zip" of "/vsizip//data/tiles.zip/dtm.tif"
/// is not found, but "/data/release.gpkg" of "/data/release.gpkg|layer=a" is. Empty: a database or a service.
std::string plain_file(const std::string& path);

}  // namespace frana
