// SPDX-License-Identifier: Apache-2.0
#include "app/input/on_demand.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/input/used_file.h"
#include "core/geometry.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "simulation/release.h"

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

Raster polygon_values_on_demand(const GridSpec& grid, const std::vector<Feature>& features,
                                const std::vector<std::optional<double>>& values) {
    const auto zones = std::make_shared<std::vector<Zone>>();  // shared by the raster's copies
    for (std::size_t f = 0; f < features.size(); ++f)
        if (values[f]) zones->push_back({features[f].shape.areas, bounds(features[f].shape.areas), *values[f]});
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
                const gis::RasterInfo& info, Findings found) {
    const GridSpec& grid = ground.terrain.grid;
    const Place where = reading.where(key);
    if (!grid.crs_wkt.empty() && info.crs_wkt.empty())
        throw Error(ErrorKind::input,
                    Problem{"has no coordinate reference system", where, info.path, "", k_state_zone_crs});
    auto file = std::make_shared<const gis::RasterOnDemand>(info.path, grid, "", gis::Resampling::automatic, "metre",
                                                            std::nullopt, where);
    found.warn_of(key, file->known().warnings);
    report_transform(key, file->known().transform, grid.cell_size, found);
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
                             const std::function<double(double)>& convert, std::vector<UsedFile>& files,
                             Findings found) {
    const gis::RasterInfo info = reading.session.read(gis::inspect_raster, path, reading.where(key));
    const File file = open_zones(reading, ground, key, info, found);
    Raster raster = raster_values_on_demand(ground.terrain.grid, file, convert);
    look_under(released, raster);
    add_to(files, key, info, file, raster);
    return raster;
}

Raster positive_values_on_demand(const SceneReading& reading, const TerrainInput& ground, const std::string& key,
                                 const std::string& path, const std::function<double(double)>& convert,
                                 std::vector<UsedFile>& files, Findings found) {
    const gis::RasterInfo info = reading.session.read(gis::inspect_raster, path, reading.where(key));
    const File file = open_zones(reading, ground, key, info, found);
    const GridSpec& grid = ground.terrain.grid;
    Raster raster = positive_values(
        raster_values_on_demand(grid, file, convert),
        gis::CrsTransform(grid.crs_wkt.empty() ? "" : info.crs_wkt, grid.crs_wkt, info.bounds).around(info.bounds));
    add_to(files, key, info, file, raster);
    return raster;
}

Raster thickness_on_demand(const ThicknessKind& kind, const GridSpec& grid,
                           const std::vector<std::shared_ptr<const gis::RasterOnDemand>>& files,
                           const std::shared_ptr<const gis::RasterOnDemand>& ground) {
    auto read = files;
    if (kind.below_dtm) read.push_back(ground);
    CellValues::Source source = [read, n = files.size(), metres = kind.metres](const CellWindow& window,
                                                                               double* values) {
        const auto cells = static_cast<std::size_t>(window.rows * window.columns);
        std::vector<std::vector<double>> parts(read.size(), std::vector<double>(cells));
        for (std::size_t k = 0; k < read.size(); ++k) read[k]->read(window, parts[k].data());
        std::vector<double> here(read.size());
        for (std::size_t i = 0; i < cells; ++i) {
            for (std::size_t k = 0; k < read.size(); ++k) here[k] = parts[k][i];
            values[i] = metres(here.back(), std::span(here).first(n));
        }
    };
    Raster thickness;
    thickness.grid = grid;
    thickness.values = CellValues::tiled(grid.rows, grid.columns, k_no_data, std::move(source));
    return thickness;
}

namespace {

// Calls visit(row, column, value) for the positive cells within an extent, reading part by part.
template <class Visit>
void for_each_positive(const Raster& thickness, const Bounds& extent, const Visit& visit) {
    constexpr std::int64_t k_part = 8 * CellValues::k_side;
    const GridSpec& grid = thickness.grid;
    const auto cells = [&](double metres, std::int64_t most) {
        return static_cast<std::int64_t>(std::clamp(metres / grid.cell_size, 0.0, static_cast<double>(most)));
    };
    const std::int64_t first_row = cells(grid.north - extent.north, grid.rows) / k_part * k_part,
                       first_column = cells(extent.west - grid.west, grid.columns) / k_part * k_part,
                       last_row = std::min(cells(grid.north - extent.south, grid.rows) + 1, grid.rows),
                       last_column = std::min(cells(extent.east - grid.west, grid.columns) + 1, grid.columns);
    for (std::int64_t row = first_row; row < last_row; row += k_part) {
        for (std::int64_t column = first_column; column < last_column; column += k_part) {
            const CellWindow window{row, column, std::min(k_part, grid.rows - row),
                                    std::min(k_part, grid.columns - column)};
            // The copy, and what it reads, lasts for this part only.
            const Raster unread = thickness;
            for (std::int64_t r = row; r < row + window.rows; ++r)
                for (std::int64_t c = column; c < column + window.columns; ++c)
                    if (const double value = std::as_const(unread).at(r, c); value > 0) visit(r, c, value);
        }
    }
}

}  // namespace

Raster positive_cells(const Raster& thickness, const Bounds& extent) {
    Raster mask(thickness.grid);
    for_each_positive(thickness, extent,
                      [&](std::int64_t row, std::int64_t column, double) { mask.at(row, column) = 1; });
    return mask;
}

Raster positive_values(const Raster& thickness, const Bounds& extent) {
    Raster values(thickness.grid, k_no_data);
    for_each_positive(thickness, extent,
                      [&](std::int64_t row, std::int64_t column, double value) { values.at(row, column) = value; });
    return values;
}

namespace {

// For the area of one CRS in another: long enough for the digits of the operation, short beside its curvature [m].
constexpr double k_side = 100;

/// A raster's own cells as seen from the working CRS. Between different CRSs lengths are in cells of the raster, which
/// may have sides in degrees.
class OwnCells {
  public:
    OwnCells(const GridSpec& grid, const GridSpec& working, const MultiPolygon& outline)
        : grid_(grid),
          to_own_(working.crs_wkt, working.crs_wkt.empty() ? "" : grid.crs_wkt, bounds(outline)),
          unit_(to_own_.is_identity() ? 1 : grid.cell_size) {
        if (to_own_.is_identity()) return;
        const Bounds box = bounds(outline);
        const Point middle{(box.west + box.east) / 2, (box.south + box.north) / 2};
        const Point west = place(to_own_({middle.x - k_side, middle.y})),
                    east = place(to_own_({middle.x + k_side, middle.y})),
                    south = place(to_own_({middle.x, middle.y - k_side})),
                    north = place(to_own_({middle.x, middle.y + k_side}));
        area_ = 4 * k_side * k_side /
                std::abs((east.x - west.x) * (north.y - south.y) - (east.y - west.y) * (north.x - south.x));
    }
    [[nodiscard]] MultiPolygon places(const MultiPolygon& outline) const {
        return moved(outline, [&](Point p) { return place(to_own_(p)); });
    }
    [[nodiscard]] double side() const { return grid_.cell_size / unit_; }
    /// Area in the working CRS of an area of one here [m2].
    [[nodiscard]] double area() const { return area_; }

  private:
    [[nodiscard]] Point place(Point map) const {
        const Point local = grid_.local_from_map(map);
        return {local.x / unit_, local.y / unit_};
    }

    const GridSpec& grid_;
    gis::CrsTransform to_own_;
    double unit_, area_ = 1;
};

double volume_inside(const Raster& thickness, const GridSpec& working, const MultiPolygon& outline) {
    const OwnCells cells(thickness.grid, working, outline);
    return volume_in_cells(thickness, cells.side(), cells.places(outline)) * cells.area();
}

/// Returns the volume of a raster of which all cells are in memory.
double volume_of_all(const Raster& thickness, const GridSpec& working, const MultiPolygon& outline) {
    double sum = 0;
    thickness.values.for_each_stored([&](std::size_t, double value) {
        if (value > 0) sum += value;
    });
    const OwnCells cells(thickness.grid, working, outline);
    return sum * cells.side() * cells.side() * cells.area();
}

/// Returns the raster's own cells, in its own CRS; none if they are not square or rotated.
std::optional<GridSpec> own_grid(const gis::RasterInfo& file, const GridSpec& working, const Session& session) {
    const bool square = !file.rotated && std::abs(file.cell_x - file.cell_y) <= 1e-9 * file.cell_x;
    if (!square) return std::nullopt;
    const bool same_crs = file.crs_wkt.empty() || working.crs_wkt.empty() ||
                          session.read(gis::crs_name, session.read(gis::horizontal_crs, file.crs_wkt)) ==
                              session.read(gis::crs_name, working.crs_wkt);
    GridSpec grid;
    grid.west = file.bounds.west;
    grid.north = file.bounds.north;
    grid.cell_size = file.cell_x;
    grid.columns = file.columns;
    grid.rows = file.rows;
    grid.crs_wkt = same_crs ? working.crs_wkt : session.read(gis::horizontal_crs, file.crs_wkt);
    return grid;
}

/// All of the file, or of a large one what is asked for.
Raster read_own(const std::string& path, const GridSpec& grid, const Session& session) {
    if (grid.cell_count() <= CellValues::k_most_dense)
        return session
            .read(gis::read_raster_on, path, grid, grid.crs_wkt, gis::Resampling::nearest, "auto", std::nullopt, "")
            .raster;
    const auto file = std::make_shared<const gis::RasterOnDemand>(path, grid, grid.crs_wkt, gis::Resampling::nearest,
                                                                  "auto", std::nullopt, path);
    return raster_values_on_demand(grid, file, [](double metres) { return metres; });
}

}  // namespace

void match_file_volume(ReleaseInput& release, const GridSpec& working_grid, const Session& session, UsedFile& used) {
    if (release.rasters.size() != 1 || release.areas.empty()) return;
    const ReleaseArea& first = release.areas.front();
    if (!first.thickness_raster || first.normal_to_bed) return;
    const gis::RasterInfo& file = release.rasters.front();
    const std::optional<GridSpec> grid = own_grid(file, working_grid, session);
    if (!grid) return;
    const Raster own = read_own(file.path, *grid, session);
    FileVolume found;
    for (ReleaseArea& area : release.areas) {
        const double volume = volume_inside(own, working_grid, area.outline);
        if (volume > 0) area.volume = volume;
        found.inside += volume;
    }
    if (grid->cell_count() <= CellValues::k_most_dense) found.all = volume_of_all(own, working_grid, first.outline);
    used.checksum.add(own);
    release.file_volume = found;
}

}  // namespace frana::app
