// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/grid_spec.h"

namespace frana::app {

/// A raster of a result that was exchanged for another would be drawn in the wrong place: throws Error(input) where the
/// cells of `file` are not those of `other`.
void require_cells(const GridSpec& grid, const std::string& file, const GridSpec& expected, const std::string& other);

}  // namespace frana::app
