// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::gis::test {

/// Returns the reasons why a file is no valid cloud-optimised GeoTIFF; empty: none. The rules are those of GDAL's
/// validator with its full check: tiles and overviews inside, directories first (the main one, then the overviews from
/// large to small), data from the smallest overview to the main image, blocks in row order, each between its size and a
/// repetition of its last four bytes.
std::vector<std::string> cog_problems(const std::string& path);

}  // namespace frana::gis::test
