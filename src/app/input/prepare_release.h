// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "gis/vector/vector_in.h"
#include "simulation/scene.h"

namespace frana::app {

/// What fails, and where it was read from.
struct ReleaseInput {
    std::vector<ReleaseArea> areas;
    std::optional<gis::PolygonLayer> perimeter;  ///< none: outlined by the thickness raster
    std::vector<gis::RasterInfo> rasters;        ///< that gave the thickness
    std::optional<double> file_volume_m3;        ///< of the thickness raster, see match_file_volume
    std::optional<Raster> solid_fraction;        ///< where the thickness is that of two phases
    double area_m2 = 0;                          ///< of the outlines, in map view
};

/// Reads perimeter and thickness onto the working grid and checks them against the ground. Adds every problem
/// to `problems` and what was read to `files`. Without a ground (null) only what needs none is checked: that the files
/// are there and make sense.
ReleaseInput prepare_release(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files,
                             RunLog& log, Problems& problems);

}  // namespace frana::app
