// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/foreign_map.h"

#include <cmath>

#include "app/text/number_text.h"
#include "core/error.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"

namespace frana::app {
namespace {

/// Returns the terrain around a raster: its own cells if in the same CRS, else warped to the raster's.
Raster terrain_for(const Raster& layer, const std::string& dtm) {
    const gis::RasterInfo info = gis::inspect_raster(dtm, "--dtm");
    const std::string& crs = layer.grid.crs_wkt;
    const bool same = crs.empty() || info.crs_wkt.empty() || gis::crs_name(info.crs_wkt) == gis::crs_name(crs);
    if (same && !info.rotated && std::abs(info.cell_x - info.cell_y) < 1e-6 * info.cell_x)
        return gis::read_result_raster(dtm);
    return gis::read_raster_on(dtm, layer.grid, "", gis::Resampling::automatic, "auto", std::nullopt, "--dtm").raster;
}

}  // namespace

ForeignMap read_foreign_map(const std::string& file, const std::optional<std::string>& dtm,
                            const std::optional<std::string>& unit, const std::optional<double>& above,
                            const Words& words) {
    ForeignMap map;
    map.source.style.words = words;
    map.layer = read_map_layer(file, {}, words, true);
    if (map.layer.unit.empty()) map.layer.unit = unit.value_or("");
    if (above) {
        for (double& value : map.layer.values.values)
            if (!(value > *above)) value = k_no_data;
        map.layer.notes.push_back(words("Only above {1}", {words.number(number_text(*above)) + " " + map.layer.unit}));
    }
    const GridSpec& grid = map.layer.values.grid;
    MapSource& source = map.source;
    if (dtm) {
        source.terrain = terrain_for(map.layer.values, *dtm);
        const Bounds ground = source.terrain.grid.bounds(), box = grid.bounds();
        if (ground.east <= box.west || ground.west >= box.east || ground.north <= box.south ||
            ground.south >= box.north) {
            throw Error(ErrorKind::input, Problem{"does not overlap the raster", "--dtm", *dtm, "",
                                                  "Check the coordinate reference systems of both files"});
        }
    }
    source.longitude_latitude = longitude_latitude(grid.crs_wkt);
    source.title = map.layer.name;
    source.foreign = true;
    source.crs_label = gis::crs_name(grid.crs_wkt);
    if (!grid.crs_wkt.empty()) {
        source.convergence_deg = gis::meridian_convergence_deg(
            grid.crs_wkt, {(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    }
    return map;
}

}  // namespace frana::app
