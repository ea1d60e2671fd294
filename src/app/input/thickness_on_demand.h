// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "app/input/prepare_release.h"
#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "params/keys/thickness.h"

namespace frana::app {

/// Makes the volume of each area that of the thickness raster inside it, over the covered parts of the raster's own
/// cells, and stores what the raster contains in release.file_volume. Does nothing if the thickness is not one vertical
/// raster of square cells; their CRS may be another than the working one. `used` is that raster: its own cells are
/// added to its checksum.
void match_file_volume(ReleaseInput& release, const GridSpec& working_grid, const Session& session, UsedFile& used);

/// The released volume must equal that of the file inside the perimeter; logs both, as a warning if they differ by a
/// percent. Warns as well if the perimeter cuts more than that off a raster that is mostly inside: a raster of this
/// mass, not of the thickness of all ground. `in_file`: release.file_volume; none: nothing to compare.
void compare_volumes(const std::optional<FileVolume>& in_file, double released, RunLog& log);

/// Thickness on a large working grid, of which nothing is read until a cell is asked for. `files` are those of the key,
/// in its order; `ground` is read for a thickness below the DTM.
Raster thickness_on_demand(const ThicknessKind& kind, const GridSpec& grid,
                           const std::vector<std::shared_ptr<const gis::RasterOnDemand>>& files,
                           const std::shared_ptr<const gis::RasterOnDemand>& ground);

/// Returns a mask of the cells of such a raster that are positive, by reading, part by part, the cells within `extent`
/// (map coordinates); only parts with such a cell remain in memory.
Raster positive_cells(const Raster& thickness, const Bounds& extent);
/// Returns the values of these cells; NaN elsewhere.
Raster positive_values(const Raster& thickness, const Bounds& extent);

}  // namespace frana::app
