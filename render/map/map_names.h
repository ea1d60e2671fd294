// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/map2d.h"
#include "render/map/map_body.h"

namespace frana::render {

/// Writes the names of places beside them where there is room, and those of lines beyond their ends, or beside them;
/// a line's name that would cover other letters everywhere is where it covers least. Call before the contours, whose
/// labels avoid them.
void draw_names(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const std::vector<Outline>& outlines);

}  // namespace frana::render
