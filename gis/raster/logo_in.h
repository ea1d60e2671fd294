// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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
Logo read_logo(const std::string& path, const std::string& where);

}  // namespace frana::gis
