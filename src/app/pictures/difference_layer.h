// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"

namespace frana::app {

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
