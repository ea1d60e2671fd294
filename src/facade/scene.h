// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/error.h"
#include "core/raster.h"
#include "facade/frana.h"

namespace frana::facade {

/// Returns why a key with this value is not for a scene in memory: an unknown key, a value that is not allowed, a file,
/// or what concerns only the files that the program reads and writes. None: it is.
std::optional<frana::Problem> problem_of_setting(const std::string& key, const std::string& value);

GridSpec spec_of(const Grid& grid);

/// Changes the values of a window, row by row.
using Change = std::function<void(const CellWindow& window, double* values)>;

/// A raster whose cells are read from values where and when they are asked for; `change` makes them the engine's.
frana::Raster raster_in_place(const GridSpec& grid, const Values& values, const Change& change = {});

}  // namespace frana::facade
