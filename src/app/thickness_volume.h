// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/prepare_release.h"

namespace frana::app {

/// Volume of the thickness raster inside the outlines, over its own cells as far as they are covered [m3];
/// none where the thickness is not one vertical raster of square cells in the working CRS.
std::optional<double> thickness_volume(const ReleaseInput& release, const GridSpec& working_grid);

/// What is released must be what the file holds; the log says both, as a warning where they differ by a
/// percent. `in_file` as above; none: nothing to compare.
void compare_volumes(std::optional<double> in_file, double released, RunLog& log);

}  // namespace frana::app
