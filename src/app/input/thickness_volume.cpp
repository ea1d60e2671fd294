// SPDX-License-Identifier: Apache-2.0
#include "app/input/thickness_volume.h"

#include <cmath>
#include <memory>

#include "app/input/thickness_on_demand.h"
#include "app/text/number_text.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "particles/seeding.h"

namespace frana::app {
namespace {

constexpr double k_worth_a_warning = 0.01;  // of the volume; smaller than the accuracy of any thickness

// Exact for a thickness that is constant over each of the raster's cells.
double volume_inside(const Raster& thickness, const MultiPolygon& outline) {
    const GridSpec& grid = thickness.grid;
    MultiPolygon local = outline;
    const auto move = [&](Ring& ring) {
        for (Point& p : ring) p = grid.local_from_map(p);
    };
    for (Polygon& polygon : local) {
        move(polygon.outer);
        for (Ring& hole : polygon.holes) move(hole);
    }
    ParticleSet pieces;
    return fill_outline(
        local, grid.cell_size,
        [&](Point p) {
            const auto column = static_cast<std::int64_t>(std::floor(p.x / grid.cell_size));
            const auto row = grid.rows - 1 - static_cast<std::int64_t>(std::floor(p.y / grid.cell_size));
            const bool inside = column >= 0 && column < grid.columns && row >= 0 && row < grid.rows;
            return inside ? thickness.at(row, column) : k_no_data;
        },
        pieces);
}

/// Returns the raster's own cells; none if they are not square, rotated, or in another CRS.
std::optional<GridSpec> own_grid(const gis::RasterInfo& file, const GridSpec& working) {
    const bool square = !file.rotated && std::abs(file.cell_x - file.cell_y) <= 1e-9 * file.cell_x;
    const bool same_crs = file.crs_wkt.empty() || working.crs_wkt.empty() ||
                          gis::crs_name(gis::horizontal_crs(file.crs_wkt)) == gis::crs_name(working.crs_wkt);
    if (!square || !same_crs) return std::nullopt;
    GridSpec grid;
    grid.west = file.bounds.west;
    grid.north = file.bounds.north;
    grid.cell_size = file.cell_x;
    grid.columns = file.columns;
    grid.rows = file.rows;
    grid.crs_wkt = working.crs_wkt;
    return grid;
}

/// All of the file, or of a large one what is asked for.
Raster read_own(const std::string& path, const GridSpec& grid) {
    if (grid.cell_count() <= CellValues::k_most_dense)
        return gis::read_raster_on(path, grid, grid.crs_wkt, gis::Resampling::nearest).raster;
    const auto file = std::make_shared<const gis::RasterOnDemand>(path, grid, grid.crs_wkt, gis::Resampling::nearest,
                                                                  "auto", std::nullopt, path);
    return thickness_on_demand(ThicknessSpec::Kind::raster, grid, {file}, nullptr);
}

}  // namespace

void match_file_volume(ReleaseInput& release, const GridSpec& working_grid, UsedFile& used) {
    if (release.rasters.size() != 1 || release.areas.empty()) return;
    const ReleaseArea& first = release.areas.front();
    if (!first.thickness_raster || first.normal_to_bed) return;
    const gis::RasterInfo& file = release.rasters.front();
    const std::optional<GridSpec> grid = own_grid(file, working_grid);
    if (!grid) return;
    const Raster own = read_own(file.path, *grid);
    double sum = 0;
    for (ReleaseArea& area : release.areas) {
        const double volume = volume_inside(own, area.outline);
        if (volume > 0) area.volume = volume;
        sum += volume;
    }
    used.checksum.add(own);
    release.file_volume_m3 = sum;
}

void compare_volumes(std::optional<double> in_file, double released, RunLog& log) {
    if (!in_file || !(*in_file > 0)) return;
    const double difference = released / *in_file - 1;
    const std::string text = "the thickness raster contains " + grouped(*in_file) +
                             " m3 inside the perimeter; the release has " + grouped(released) + " m3";
    if (std::abs(difference) > k_worth_a_warning)
        log.warn(text + " (" + number_text(100 * difference, 2) + " %)");
    else
        log.note(text);
}

}  // namespace frana::app
