// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/geometry.h"

namespace frana::gis {

/// The most pixels of a logo's side: it is printed a few centimetres wide.
inline constexpr int k_largest_logo = 8000;

/// A logo as it is printed.
struct Logo {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< on white where the file is transparent
    std::uint32_t checksum = 0;
};

/// Reads a PNG or JPEG file. `where` names the key or option. Throws Error(input).
Logo read_logo(const std::string& path, const Place& where);

/// A picture for a page of HTML.
struct PagePicture {
    std::string mime;   ///< "image/jpeg"
    std::string bytes;  ///< of the file
    int width = 0, height = 0;
};

/// Returns a PNG file as it is if it is small, otherwise as JPEG: at most `most_columns` wide, in the best quality that
/// needs no more than `most_bytes`. A relief needs a fifth of its bytes as PNG, and the letters on it stay sharp.
/// Throws Error(environment) if the file cannot be read or the picture cannot be made.
PagePicture page_picture(const std::string& path, int most_columns, std::size_t most_bytes);

/// Checks that a file can be the background of a map: an orthophoto or a scanned or tiled map in bytes, in one band
/// (grey or with a colour table) or three and more, with a position on the ground. `crs_wkt` is the map's. `where`
/// names the key. Returns a checksum of its content; of a large file that of some hundred blocks. Throws Error(input).
std::uint32_t check_picture(const std::string& path, const std::string& crs_wkt, const Place& where);

/// Returns the part of such a file inside `box` in the map's CRS, warped by GDAL to the given number of pixels: red,
/// green, blue and opacity of each, row by row from the top, colours multiplied by the opacity; 0 where the file has no
/// data. Throws Error(input).
std::vector<std::uint8_t> warp_picture(const std::string& path, const std::string& crs_wkt, const Bounds& box,
                                       int width, int height);

/// The position of a map on the ground.
struct PicturePlace {
    Bounds page;  ///< of the whole page, margins included, in coordinates of the page (MapTurn)
    Bounds map;   ///< inside the map's frame
    std::string crs_wkt;
    MapTurn turn{};
};

/// Writes a PDF of one page, given as bytes; with a place it becomes a geospatial PDF (ISO 32000) whose map frame is
/// the neat line. Written aside and renamed. Throws Error(environment).
void write_pdf(const std::string& path, const std::string& bytes, const std::optional<PicturePlace>& place);

}  // namespace frana::gis
