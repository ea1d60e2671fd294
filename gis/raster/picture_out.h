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

/// The position of a map on a page and on the ground.
struct PicturePlace {
    Bounds page;  ///< of the whole picture, margins included, in map coordinates
    Bounds map;   ///< inside the map's frame
    std::string crs_wkt;
};

/// Writes a cloud-optimised GeoTIFF of three bytes per pixel with its position. Written aside and renamed. Throws
/// Error(environment).
void write_picture_geotiff(const std::string& path, const PicturePixels& picture, const Bounds& box,
                           const std::string& crs_wkt, const std::map<std::string, std::string>& metadata);

/// Returns whether a file is a map written by write_picture_geotiff.
bool is_drawn_geotiff(const std::string& path);

/// Writes a PDF of one page, as large as the pixels are at `dots_per_inch`; with a place it is a geospatial PDF (ISO
/// 32000) whose map frame is the neat line. `title` is stored in its properties. Written aside and renamed. Throws
/// Error(environment).
void write_picture_pdf(const std::string& path, const PicturePixels& picture, double dots_per_inch,
                       const std::optional<PicturePlace>& place, const std::string& title);

}  // namespace frana::gis
