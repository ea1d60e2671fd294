// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "render/canvas/image.h"

namespace frana::render {

/// A picture reduced to at most 255 colours: the limit of a GIF frame besides the transparent one.
struct IndexedImage {
    std::vector<Rgb> colours;
    std::vector<std::uint8_t> indices;  ///< one per pixel
};

/// Chooses colours by dividing the picture's range of colours at medians; a picture of few colours keeps them exactly.
IndexedImage reduce_colours(const Image& image);

}  // namespace frana::render
