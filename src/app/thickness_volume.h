// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/prepare_release.h"

namespace frana::app {

/// Volume of the thickness raster inside the outlines, summed over its own cells [m3]; none where the
/// thickness is not one vertical raster of square cells in the working CRS.
std::optional<double> thickness_volume(const ReleaseInput& release, const GridSpec& working_grid);

/// Interpolation to the working grid and the particles changes a volume a little; the log says by how much,
/// as a warning from one percent on. `in_file` as above; none: nothing to compare.
void compare_volumes(std::optional<double> in_file, double released, RunLog& log);

}  // namespace frana::app
