// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/ground_statistics.h"
#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "gis/vector/vector_in.h"
#include "simulation/scene.h"

namespace frana::app {

/// The release and its sources.
struct ReleaseInput {
    std::vector<ReleaseArea> areas;
    std::optional<gis::PolygonLayer> perimeter;  ///< none: outlined by the thickness raster
    std::vector<gis::RasterInfo> rasters;        ///< source of the thickness
    std::optional<FileVolume> file_volume;       ///< of the thickness raster, see match_file_volume
    std::optional<Raster> solid_fraction;        ///< if the thickness is that of two phases
    double area_m2 = 0;                          ///< of the outlines, in map view
    std::optional<GroundStatistics> ground;      ///< the DTM under the outlines
    std::optional<Raster> before;                ///< of a thickness that is a difference, until it is checked
};

/// Reads perimeter and thickness onto the working grid and checks them against the terrain. Adds every problem to
/// `problems` and the files read to `files`. Without terrain (null) only checks what needs none: that the files exist
/// and are valid.
ReleaseInput prepare_release(const SceneReading& reading, const TerrainInput* ground, std::vector<UsedFile>& files,
                             Findings found, Problems& problems);

}  // namespace frana::app
