// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frana::gis::test {

/// Three bytes a pixel, row by row from the top.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// The first three bands of any picture that GDAL reads; fails the test where it reads none.
Pixels pixels_of(const std::string& path);

/// What keeps a PDF from showing just these pixels at this print size; empty: nothing. Poppler (Debian:
/// poppler-utils), by which most viewers read, must have no word of complaint, must find one picture with
/// these very pixels, and must draw a page that is this picture, but for its own way of stretching it by a
/// pixel. Writes beside the file.
std::vector<std::string> pdf_problems(const std::string& path, const Pixels& expected, double dots_per_inch);

}  // namespace frana::gis::test
