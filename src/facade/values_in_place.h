// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/raster.h"
#include "facade/frana.h"

namespace frana::facade {

GridSpec spec_of(const Grid& grid);

/// Changes the values of a window, row by row.
using Change = std::function<void(const CellWindow& window, double* values)>;

/// A raster whose cells are read from values where and when they are asked for; `change` makes them the engine's.
frana::Raster raster_in_place(const GridSpec& grid, const Values& values, const Change& change = {});

}  // namespace frana::facade
