// SPDX-License-Identifier: Apache-2.0
#include "app/input/zones_on_demand.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/input/thickness_on_demand.h"
#include "app/input/transform_report.h"
#include "core/geometry.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"

namespace frana::app {
namespace {

struct Zone {
    MultiPolygon parts;
    Bounds box;
    double value;
};

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
            if (are_apart(part.bounds(), zone.box)) continue;
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

namespace {

using File = std::shared_ptr<const gis::RasterOnDemand>;

File open_zones(const SceneReading& reading, const TerrainInput& ground, const std::string& key,
                const gis::RasterInfo& info, RunLog& log) {
    const GridSpec& grid = ground.terrain.grid;
    const std::string where = reading.where(key);
    if (!grid.crs_wkt.empty() && info.crs_wkt.empty())
        throw Error(ErrorKind::input,
                    Problem{"has no coordinate reference system", where, info.path, "", k_state_zone_crs});
    auto file = std::make_shared<const gis::RasterOnDemand>(info.path, grid, "", gis::Resampling::automatic, "metre",
                                                            std::nullopt, where);
    log.warn_of(key, file->known().warnings);
    report_transform(key, file->known().transform, grid.cell_size, log);
    return file;
}

void add_to(std::vector<UsedFile>& files, const std::string& key, const gis::RasterInfo& info, const File& file,
            const Raster& raster) {
    files.push_back(used_raster("Zones: " + key, info, file->known()));
    do_not_count_nodata(files.back());
    files.back().checksum.add(raster);
}

}  // namespace

void look_under(const MultiPolygon& released, const Raster& raster) {
    gis::visit_cells(released, raster.grid, gis::Cover::closed,
                     [&](std::int64_t row, std::int64_t column) { (void)raster.at(row, column); });
}

Raster zone_raster_on_demand(const SceneReading& reading, const TerrainInput& ground, const std::string& key,
                             const std::string& path, const MultiPolygon& released,
                             const std::function<double(double)>& convert, std::vector<UsedFile>& files, RunLog& log) {
    const gis::RasterInfo info = reading.session.read(gis::inspect_raster, path, reading.where(key));
    const File file = open_zones(reading, ground, key, info, log);
    Raster raster = raster_values_on_demand(ground.terrain.grid, file, convert);
    look_under(released, raster);
    add_to(files, key, info, file, raster);
    return raster;
}

Raster positive_values_on_demand(const SceneReading& reading, const TerrainInput& ground, const std::string& key,
                                 const std::string& path, const std::function<double(double)>& convert,
                                 std::vector<UsedFile>& files, RunLog& log) {
    const gis::RasterInfo info = reading.session.read(gis::inspect_raster, path, reading.where(key));
    const File file = open_zones(reading, ground, key, info, log);
    const GridSpec& grid = ground.terrain.grid;
    Raster raster = positive_values(
        raster_values_on_demand(grid, file, convert),
        gis::CrsTransform(grid.crs_wkt.empty() ? "" : info.crs_wkt, grid.crs_wkt, info.bounds).around(info.bounds));
    add_to(files, key, info, file, raster);
    return raster;
}

}  // namespace frana::app
