// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/grid_spec.h"

namespace frana::gis {

/// Checks that a file can be the background of a map: an orthophoto or a scanned or tiled map in bytes, in one band
/// (grey or with a colour table) or three and more, with a position on the ground. `crs_wkt` is the map's. `where`
/// names the key. Returns a checksum of its content; of a large file that of some hundred blocks. Throws Error(input).
std::uint32_t check_picture(const std::string& path, const std::string& crs_wkt, const std::string& where);

/// Returns the part of such a file inside `box` in the map's CRS, warped by GDAL to the given number of pixels: red,
/// green, blue and opacity of each, row by row from the top, colours multiplied by the opacity; 0 where the file has no
/// data. Throws Error(input).
std::vector<std::uint8_t> warp_picture(const std::string& path, const std::string& crs_wkt, const Bounds& box,
                                       int width, int height);

}  // namespace frana::gis
