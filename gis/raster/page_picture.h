// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace frana::gis {

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

}  // namespace frana::gis
