// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/canvas/map_layout.h"
#include "render/canvas/page.h"

namespace frana::render {

/// Draws one part of a plate in the given number of pixels.
using PlatePart = std::function<Page(int width, int height)>;

/// Several pictures on one page under a common title, row by row.
struct Plate {
    std::string title, subtitle, foot;
    int across = 2;
    std::vector<PlatePart> parts;
};

/// Draws the plate; larger than requested if parts would be smaller than 480 x 360. Throws as the parts do. `texts`, if
/// given, receives the plate's own texts.
Page draw_plate(const Plate& plate, int width, int height, std::vector<TextBox>* texts = nullptr);

}  // namespace frana::render
