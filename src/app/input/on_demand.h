// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare_release.h"
#include "app/input/prepare_terrain.h"
#include "app/input/used_file.h"
#include "app/text/run_log.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "params/keys/thickness.h"

namespace frana::app {

inline constexpr const char* k_state_zone_crs =
    "Write one into the file, for example with gdal_edit.py -a_srs EPSG:...";

/// Reads the cells under the release, so that `frana check` can show them and wrong values are known at once.
void look_under(const MultiPolygon& released, const Raster& raster);

/// The raster `path` of values of `key` on a working grid that is read on demand: nothing is read yet but what lies
/// under `released` (map coordinates). `convert` makes a value out of what the file has, or throws; it is called as
/// long as the raster exists. Adds the file to `files`. Throws Error(input).
Raster zone_raster_on_demand(const SceneReading& reading, const TerrainInput& ground, const std::string& key,
                             const std::string& path, const MultiPolygon& released,
                             const std::function<double(double)>& convert, std::vector<UsedFile>& files,
                             Findings found);

/// The same, all of the file being read now, in parts: memory is taken only where values are positive.
Raster positive_values_on_demand(const SceneReading& reading, const TerrainInput& ground, const std::string& key,
                                 const std::string& path, const std::function<double(double)>& convert,
                                 std::vector<UsedFile>& files, Findings found);

/// A value of the material on a large working grid, of which nothing exists until a cell is asked for: that of each
/// polygon in the cells whose centre is inside, the later one where two overlap; NaN elsewhere. `values` has one for
/// each of the features, or none.
Raster polygon_values_on_demand(const GridSpec& grid, const std::vector<Feature>& features,
                                const std::vector<std::optional<double>>& values);

/// The same from a raster of any kind. `convert` makes a value out of what the file has, or throws; not called for NaN.
Raster raster_values_on_demand(const GridSpec& grid, const std::shared_ptr<const gis::RasterOnDemand>& file,
                               const std::function<double(double)>& convert);

/// Makes the volume of each area that of the thickness raster inside it, over the covered parts of the raster's own
/// cells, and stores what the raster contains in release.file_volume. Does nothing if the thickness is not one vertical
/// raster of square cells; their CRS may be another than the working one. `used` is that raster: its own cells are
/// added to its checksum.
void match_file_volume(ReleaseInput& release, const GridSpec& working_grid, const Session& session, UsedFile& used);

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
