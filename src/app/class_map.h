// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/map_source.h"

namespace frana::app {

/// Draws a raster of classes to a PNG, with the terrain and the release of `source`, its notes beside it, and
/// the scar in a colour that stands out from the classes. Throws Error.
void draw_class_map(const MapSource& source, const std::string& what, const std::string& legend,
                    const Raster& classes, const std::vector<render::ClassLabel>& categories,
                    const std::string& path);

}  // namespace frana::app
