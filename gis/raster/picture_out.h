// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "core/grid_spec.h"

namespace frana::gis {

/// A picture of opaque pixels: red, green, blue of each, row by row from the top.
struct PicturePixels {
    int width = 0, height = 0;
    std::span<const std::uint8_t> rgb;
};

/// The position of a map on the ground.
struct PicturePlace {
    Bounds page;  ///< of the whole page, margins included, in map coordinates
    Bounds map;   ///< inside the map's frame
    std::string crs_wkt;
};

/// Writes a cloud-optimised GeoTIFF of three bytes per pixel with its position. Written aside and renamed. Throws
/// Error(environment).
void write_picture_geotiff(const std::string& path, const PicturePixels& picture, const Bounds& box,
                           const std::string& crs_wkt, const std::map<std::string, std::string>& metadata);

/// Returns whether a file is a map written by write_picture_geotiff.
bool is_drawn_geotiff(const std::string& path);

/// Writes a PDF of one page, given as bytes; with a place it becomes a geospatial PDF (ISO 32000) whose map frame is
/// the neat line. Written aside and renamed. Throws Error(environment).
void write_pdf(const std::string& path, const std::string& bytes, const std::optional<PicturePlace>& place);

}  // namespace frana::gis
