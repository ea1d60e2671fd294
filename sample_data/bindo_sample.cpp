// SPDX-License-Identifier: Apache-2.0
#include "sample_data/bindo_sample.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "core/raster.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_out.h"
#include "sample_data/bindo_landslide.h"
#include "sample_data/bindo_terrain.h"
#include "sample_data/shapefile.h"

namespace frana::sample {
namespace {

Raster sampled(const GridSpec& grid, const std::function<double(Point)>& value) {
    Raster raster(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const Point local = grid.local_from_map(grid.cell_centre(row, column));
            raster.at(row, column) = std::round(value(local) * 100) / 100;
        }
    }
    return raster;
}

/// Converts local metres to another CRS, rounded to `parts` of its unit.
Ring moved(const Ring& local, const GridSpec& grid, const std::string& crs_wkt, double parts) {
    const gis::CrsTransform transform(grid.crs_wkt, crs_wkt, grid.bounds());
    Ring out;
    for (const Point& point : local) {
        const Point to = transform(grid.map_from_local(point));
        out.push_back({std::round(to.x * parts) / parts, std::round(to.y * parts) / parts});
    }
    return out;
}

}  // namespace

void write_bindo_sample(const std::string& folder) {
    const auto file = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
    GridSpec grid = bindo_grid();
    grid.crs_wkt = gis::crs_from_user("EPSG:32632", "");
    const std::map<std::string, std::string> origin{{"ORIGIN", "Synthetic: made by frana's sample generator"}};
    gis::write_geotiff(file("dtm.tif"), sampled(grid, bindo_height),
                       {"dtm", "Synthetic terrain before the failure", "m", origin});
    gis::write_geotiff(file("thickness.tif"), sampled(grid, release_thickness),
                       {"thickness", "Synthetic thickness of the failing mass, vertical", "m", origin});
    write_shapefile(file("perimeter.shp"), 4326, moved(release_rim(), grid, gis::crs_from_user("EPSG:4326", ""), 1e9),
                    "failing mass");
    write_shapefile(file("scar.shp"), 3003, moved(scar_outline(), grid, gis::crs_from_user("EPSG:3003", ""), 1e3),
                    "outline after the event");
}

}  // namespace frana::sample
