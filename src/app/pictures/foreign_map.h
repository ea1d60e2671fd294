// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/pictures/map_source.h"

namespace frana::app {

/// A raster of any program with its known properties for a map.
struct ForeignMap {
    MapSource source;
    MapLayer layer;
};

/// Reads a raster (square cells, north up, in metres; no flow where 0 and nodata) and the terrain to draw it on, which
/// may have other cells and another CRS. `unit` is used if the file names none; values that are not `above` a limit are
/// omitted, with a note on the map (some programs leave tiny depths everywhere). Throws Error(input).
ForeignMap read_foreign_map(const std::string& file, const std::optional<std::string>& dtm,
                            const std::optional<std::string>& unit, const std::optional<double>& above,
                            const Words& words);

}  // namespace frana::app
