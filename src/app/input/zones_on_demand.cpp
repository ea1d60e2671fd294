// SPDX-License-Identifier: Apache-2.0
#include "app/input/zones_on_demand.h"

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "gis/raster/footprint.h"

namespace frana::app {
namespace {

struct Zone {
    MultiPolygon parts;
    Bounds box;
    double value;
};

bool overlap(const Bounds& a, const Bounds& b) {
    return a.west < b.east && b.west < a.east && a.south < b.north && b.south < a.north;
}

Raster unread(const GridSpec& grid, CellValues::Source source) {
    Raster raster;
    raster.grid = grid;
    raster.values = CellValues::tiled(grid.rows, grid.columns, k_no_data, std::move(source));
    return raster;
}

}  // namespace

Raster polygon_values_on_demand(const GridSpec& grid, const std::vector<PolygonFeature>& features,
                                const std::vector<std::optional<double>>& values) {
    const auto zones = std::make_shared<std::vector<Zone>>();  // shared by the raster's copies
    for (std::size_t f = 0; f < features.size(); ++f)
        if (values[f]) zones->push_back({features[f].parts, bounds(features[f].parts), *values[f]});
    return unread(grid, [grid, zones](const CellWindow& window, double* cells) {
        const GridSpec part = part_of(grid, window);
        std::fill_n(cells, window.rows * window.columns, k_no_data);
        for (const Zone& zone : *zones) {
            if (!overlap(part.bounds(), zone.box)) continue;
            gis::visit_cells(zone.parts, part, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
                cells[row * window.columns + column] = zone.value;
            });
        }
    });
}

Raster raster_values_on_demand(const GridSpec& grid, const std::shared_ptr<const gis::RasterOnDemand>& file,
                               const std::function<double(double)>& convert) {
    return unread(grid, [file, convert](const CellWindow& window, double* cells) {
        file->read(window, cells);
        for (std::int64_t i = 0; i < window.rows * window.columns; ++i)
            if (!std::isnan(cells[i])) cells[i] = convert(cells[i]);
    });
}

}  // namespace frana::app
