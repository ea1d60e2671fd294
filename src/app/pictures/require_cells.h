// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/grid_spec.h"

namespace frana::app {

/// Throws Error(input) if the cells of `file` are not those of `other`: a raster of a result that was exchanged for
/// another would be drawn in the wrong place.
void require_cells(const GridSpec& grid, const std::string& file, const GridSpec& expected, const std::string& other);

}  // namespace frana::app
