// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/input/used_file.h"
#include "app/text/run_log.h"
#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "params/scene/read_scene.h"

namespace frana::app {

/// The ground on the working grid, and what was done to it.
struct TerrainInput {
    gis::RasterInfo file;   ///< as the DTM file says; its CRS replaced by terrain.dtm-crs where that is given
    Raster terrain;         ///< on the working grid, whose CRS it carries; NaN: no data
    std::string crs_label;  ///< of the working CRS; "local" without one
    UsedFile used;
    std::int64_t nodata_cells = 0;
    std::int64_t filled_cells = 0;
    std::shared_ptr<const gis::RasterOnDemand>
        on_demand;  ///< of a large DTM, read where the flow comes; null: all read
};

/// Reads the DTM onto the working grid; a large one only where somebody asks for its elevations, with a few samples to
/// check. Adds every problem to `problems`; none is returned when the ground is
/// not known.
std::optional<TerrainInput> prepare_terrain(const SceneReading& reading, Findings found, Problems& problems);

/// Tells cells whose elevation was interpolated; none if there are none.
std::optional<Sentence> filled_warning(const TerrainInput& input);

/// Looks at what was read of a large DTM so far, as check_terrain at all of a small one: the ground under the release.
void check_ground_read(const SceneReading& reading, const TerrainInput& ground, const Raster& terrain, Findings found);

}  // namespace frana::app
