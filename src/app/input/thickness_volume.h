// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/input/prepare_release.h"

namespace frana::app {

/// Makes each area release what the thickness raster holds inside it, over the raster's own cells as far as they are
/// covered, and keeps the sum in release.file_volume_m3. Nothing where the thickness is not one vertical raster of
/// square cells in the working CRS. `used` is that raster: its own cells count in its checksum too.
void match_file_volume(ReleaseInput& release, const GridSpec& working_grid, UsedFile& used);

/// What is released must be what the file holds; the log says both, as a warning where they differ by a
/// percent. `in_file`: release.file_volume_m3; none: nothing to compare.
void compare_volumes(std::optional<double> in_file, double released, RunLog& log);

}  // namespace frana::app
