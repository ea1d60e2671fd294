// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"

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

/// The difference of one raster of two results, and what its maps share.
struct DifferenceMap {
    MapSource source;
    MapLayer layer;
};

/// Returns `first` minus `second`. Where only one of the flows came, depth, speed and the like of the other are 0;
/// times of arrival are compared where both came. The cells must be of the same size, CRS and lattice; the map covers
/// those of both results. Nothing is resampled. Classes are symmetric about zero: the bounds of the quantity's fixed
/// classes, up to five on each side, as `first` chose them. Texts are in the language of `first`; that of `second` must
/// be the same. Throws Error(input).
DifferenceMap difference_map(const ResultReader& first, const ResultReader& second, const std::string& name);

}  // namespace frana::app
