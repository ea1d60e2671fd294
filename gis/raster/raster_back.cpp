// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_source.h"

namespace frana::gis {

Raster read_result_raster(const std::string& path) {
    const GdalSession session;
    const RasterSource source(path, path, true);
    const RasterInfo& info = source.info();
    const auto refuse = [&](const std::string& what, const std::string& value) {
        return Error(ErrorKind::input, Problem{what, path, value, "north-up rasters with square cells, in metres",
                                               "Warp it first (gdalwarp -t_srs EPSG:... -tr SIZE SIZE)"});
    };
    const GeoTransform& g = source.geo_transform();
    if (info.rotated || g[1] <= 0 || g[5] >= 0) throw refuse("the raster is not north up", "");
    // Files round their geotransform; over all columns the two sides may differ by a thousandth of a cell.
    const double longest = static_cast<double>(std::max(info.columns, info.rows));
    if (std::abs(info.cell_x - info.cell_y) * longest > 1e-3 * info.cell_x) {
        throw refuse("the raster's cells are not square",
                     std::to_string(info.cell_x) + " by " + std::to_string(info.cell_y));
    }
    if (!info.crs_wkt.empty() && !is_projected_in_metres(info.crs_wkt)) {
        throw refuse("the raster's coordinates are not in metres", info.crs_label);
    }
    GridSpec grid;
    grid.west = info.bounds.west;
    grid.north = info.bounds.north;
    grid.cell_size = info.cell_x;
    grid.columns = info.columns;
    grid.rows = info.rows;
    grid.crs_wkt = info.crs_wkt.empty() ? "" : horizontal_crs(info.crs_wkt);
    // What a sparse file does not contain is no data, or 0 where the file names no such value.
    Raster raster(grid, info.has_nodata ? k_no_data : 0);
    if (!raster.values.is_tiled()) {
        raster.values = source.read({0, 0, static_cast<int>(info.columns), static_cast<int>(info.rows)},
                                    info.vertical_scale_to_metres);
        return raster;
    }
    constexpr std::int64_t k_at_once = 4 * CellValues::k_side;
    for (std::int64_t row = 0; row < grid.rows; row += k_at_once) {
        for (std::int64_t column = 0; column < grid.columns; column += k_at_once) {
            const Window window{static_cast<int>(column), static_cast<int>(row),
                                static_cast<int>(std::min(k_at_once, grid.columns - column)),
                                static_cast<int>(std::min(k_at_once, grid.rows - row))};
            if (!source.holds_any(window)) continue;
            const std::vector<double> values = source.read(window, info.vertical_scale_to_metres);
            for (std::size_t k = 0; k < values.size(); ++k)
                if (!std::isnan(values[k]))
                    raster.at(row + static_cast<std::int64_t>(k) / window.columns,
                              column + static_cast<std::int64_t>(k) % window.columns) = values[k];
        }
    }
    return raster;
}

}  // namespace frana::gis
