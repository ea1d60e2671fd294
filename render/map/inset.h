// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "render/canvas/page_style.h"
#include "render/canvas/sheet.h"
#include "render/map/map_body.h"

namespace frana::render {

/// Returns the frame of a small map of all the terrain within the available room; none if the room is too small or the
/// window shows nearly all of the terrain anyway.
std::optional<MapFrame> inset_frame(const Bounds& terrain, const Bounds& window, const PageStyle& style,
                                    const PageBox& room);

/// Draws the relief of all the terrain, of the inset's size; its frame and the map's window as a rectangle in it go to
/// the sheet.
Image draw_inset(Sheet& sheet, const PageStyle& style, const MapFrame& inset, const Raster& terrain,
                 const Bounds& window);

}  // namespace frana::render
