// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/pictures/map_source.h"

namespace frana::app {

/// A raster of any program's with what can be known of its map.
struct ForeignMap {
    MapSource source;
    MapLayer layer;
};

/// Reads a raster (square cells, north up, in metres; 0 and nodata are where nothing flowed) and the terrain to draw
/// it on, which may have other cells and another CRS. `unit` stands in for one that the file does not name; values that
/// are not `above` a limit are left out, which the map says (some programs leave a animation of next to nothing
/// everywhere). Throws Error(input).
ForeignMap read_foreign_map(const std::string& file, const std::optional<std::string>& dtm,
                            const std::optional<std::string>& unit, const std::optional<double>& above);

}  // namespace frana::app
