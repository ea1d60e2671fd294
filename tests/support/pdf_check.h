// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frana::gis::test {

/// Three bytes per pixel, row by row from the top.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Returns the first three bands of any picture that GDAL reads; fails the test if it reads none.
Pixels pixels_of(const std::string& path);

/// Returns the reasons why a PDF does not show these pixels at this print size with searchable letters; empty: none.
/// Poppler (Debian: poppler-utils), used by most viewers, must report no error, must draw a page like this picture,
/// whose lines and letters it may move by a pixel, and must find every font in the file. Writes files beside it.
std::vector<std::string> pdf_problems(const std::string& path, const Pixels& expected, double dots_per_inch);

/// Returns the text that Poppler finds in a PDF, as it is placed on the page.
std::string pdf_text(const std::string& path);

}  // namespace frana::gis::test
