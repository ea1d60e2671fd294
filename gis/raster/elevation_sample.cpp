// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/elevation_sample.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_warp.h"

namespace frana::gis {

std::vector<ElevationSample> sample_elevations(const RasterInfo& dtm, const std::string& target_crs_wkt,
                                               const Bounds& window, int most_per_side,
                                               const std::string& vertical_unit, std::optional<double> nodata_value) {
    const GdalSession session;
    RasterSource source(dtm.path, dtm.path);
    if (nodata_value) source.declare_nodata(*nodata_value);
    const double unit =
        vertical_unit == "auto" ? dtm.vertical_scale_to_metres : vertical_unit_named(vertical_unit).metres;
    const CrsTransform back(target_crs_wkt, target_crs_wkt.empty() ? "" : dtm.crs_wkt, window);
    const CrsTransform to_target(target_crs_wkt.empty() ? "" : dtm.crs_wkt, target_crs_wkt, back.around(window));
    // A grid as coarse as the sample, only to find the part of the file below it.
    GridSpec grid{window.west,   window.north,  std::max(window.width(), window.height()) / most_per_side,
                  most_per_side, most_per_side, target_crs_wkt};
    const Window cells = RasterWarp(source, to_target, GRA_NearestNeighbour, unit).source_window(grid, Point{1, 1});
    if (cells.empty()) return {};
    const int columns = std::min(cells.columns, most_per_side), rows = std::min(cells.rows, most_per_side);
    const std::vector<double> values = source.read_coarse(cells, columns, rows, unit);
    auto next = values.begin();
    std::vector<ElevationSample> samples;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double elevation = *next++;
            if (std::isnan(elevation)) continue;
            const Point cell{cells.column + (column + 0.5) * cells.columns / columns,
                             cells.row + (row + 0.5) * cells.rows / rows};
            double x = source.map_from_cell(cell).x, y = source.map_from_cell(cell).y;
            if (!to_target.apply({&x, 1}, {&y, 1}, false)) continue;
            samples.push_back({{x, y}, elevation});
        }
    }
    return samples;
}

}  // namespace frana::gis
