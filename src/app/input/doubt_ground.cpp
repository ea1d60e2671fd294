// SPDX-License-Identifier: Apache-2.0
#include "app/input/doubt_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/ground_doubts.h"
#include "analysis/ground_statistics.h"
#include "app/text/number_text.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/working_grid.h"
#include "simulation/run_warnings.h"

namespace frana::app {
namespace {

constexpr std::int64_t k_most_side = 3000;  // cells looked at: half a second
// Reaches of landslides whose friction is not one number: their travel angles are mostly greater.
constexpr double k_usual_friction = 0.2, k_known_friction = 0.05;

/// A raster to look at, the part of it that can be reached, and what its cells are.
struct LookedAt {
    std::optional<Raster> read;       ///< none: the scene's terrain
    const Raster* terrain = nullptr;  ///< the scene's
    Raster path;
    double cell_size = 0;                           ///< [m]
    const gis::CrsTransform* to_working = nullptr;  ///< of the ground's coordinates; null: they are the working ones

    [[nodiscard]] const Raster& ground() const { return read ? *read : *terrain; }
    [[nodiscard]] Sentence at(Point place) const {
        if (to_working) place = (*to_working)(place);
        return worded("E {1}, N {2}", {numeral(number_text(place.x, 9)), numeral(number_text(place.y, 9))});
    }
};

Bounds united(const Bounds& a, const Bounds& b) {
    return {std::min(a.west, b.west), std::min(a.south, b.south), std::max(a.east, b.east), std::max(a.north, b.north)};
}

/// The window of a grid around some cells, no larger than is looked at.
CellWindow window_around(const GridSpec& grid, const Bounds& box, double margin) {
    const auto part = [&](double from, double to, std::int64_t all) {
        auto first = static_cast<std::int64_t>(std::floor(std::max(from, 0.0)));
        auto end = static_cast<std::int64_t>(std::ceil(std::clamp(to, 0.0, static_cast<double>(all))));
        if (end - first > k_most_side) {
            first = std::max<std::int64_t>(0, (first + end - k_most_side) / 2);
            end = first + k_most_side;
        }
        return std::pair{first, end - first};
    };
    const auto [row, rows] = part((grid.north - box.north) / grid.cell_size - margin,
                                  (grid.north - box.south) / grid.cell_size + margin, grid.rows);
    const auto [column, columns] = part((box.west - grid.west) / grid.cell_size - margin,
                                        (box.east - grid.west) / grid.cell_size + margin, grid.columns);
    return {row, column, std::max<std::int64_t>(rows, 0), std::max<std::int64_t>(columns, 0)};
}

/// Where material comes from.
std::optional<Bounds> origin_of(const Scene& scene) {
    std::optional<Bounds> box;
    const auto add = [&](const Bounds& part) { box = box ? united(*box, part) : part; };
    for (const ReleaseArea& area : scene.release) add(bounds(area.outline));
    for (const Inflow& inflow : scene.inflows) add(bounds(MultiPolygon{{inflow.line, {}}}));
    return box;
}

/// Heights of the mass over the ground where it starts [m].
Raster start_of(const Scene& scene, const GridSpec& grid) {
    Raster start(grid);
    for (const ReleaseArea& area : scene.release) {
        const double mean = area.volume ? *area.volume / frana::area(area.outline) : area.thickness;
        const double head = area.speed * area.speed / (2 * scene.numerics.gravity);
        gis::visit_cells(area.outline, grid, gis::Cover::closed, [&](std::int64_t row, std::int64_t column) {
            start.at(row, column) = std::max(mean, 1.0) + head;
        });
    }
    for (const Inflow& inflow : scene.inflows) {
        for (const Point& point : inflow.line) {
            const auto row = static_cast<std::int64_t>(std::floor((grid.north - point.y) / grid.cell_size)),
                       column = static_cast<std::int64_t>(std::floor((point.x - grid.west) / grid.cell_size));
            if (row >= 0 && column >= 0 && row < grid.rows && column < grid.columns) start.at(row, column) = 1;
        }
    }
    return start;
}

/// The working grid with what can be reached; a large one around the release only.
LookedAt on_working_grid(const SceneReading& reading, const Prepared& prepared, const Bounds& origin) {
    const Scene& scene = prepared.scene;
    LookedAt here;
    here.terrain = &scene.terrain;
    here.cell_size = scene.grid.cell_size;
    if (const auto& file = prepared.ground.on_demand) {
        const CellWindow window = window_around(scene.grid, origin, k_most_side / 3.0);
        here.read.emplace(part_of(scene.grid, window));
        file->read(window, here.read->values.data());
    }
    const double friction = sure_friction(reading.scene);
    here.path = reachable_ground(here.ground(), start_of(scene, here.ground().grid),
                                 friction < k_known_friction ? k_usual_friction : friction);
    return here;
}

/// The same ground in the cells of its file; none where these are not square.
std::optional<LookedAt> on_own_cells(const SceneReading& reading, const Prepared& prepared, const LookedAt& working,
                                     const gis::CrsTransform& to_working) {
    gis::RasterInfo file = prepared.ground.file;
    const TerrainSpec& spec = reading.scene.terrain;
    if (file.rotated || std::abs(file.cell_x - file.cell_y) > 1e-6 * file.cell_x) return std::nullopt;
    const GridSpec& grid = working.ground().grid;
    Bounds box{grid.east(), grid.north, grid.west, grid.south()};
    working.path.values.for_each_stored([&](std::size_t cell, double on) {
        if (!(on > 0)) return;
        const auto at = static_cast<std::int64_t>(cell);
        const Point centre = grid.cell_centre(at / grid.columns, at % grid.columns);
        box = united(box, {centre.x, centre.y, centre.x, centre.y});
    });
    if (!(box.west < box.east) || !(box.south < box.north)) return std::nullopt;
    const gis::CrsTransform to_file(grid.crs_wkt, file.crs_wkt, box);
    file.crs_wkt.clear();
    const GridSpec own = gis::working_grid(file, "", std::nullopt, std::nullopt);
    LookedAt here;
    const GridSpec cells = part_of(own, window_around(own, to_file.around(box), 8));
    gis::RasterRead read = gis::read_raster_on(spec.dtm, cells, "", gis::Resampling::nearest, spec.vertical_unit,
                                               spec.nodata_value, reading.where("terrain.dtm"));
    here.read = std::move(read.raster);
    here.path = Raster(cells);
    here.to_working = &to_working;
    std::vector<double> x(static_cast<std::size_t>(cells.columns)), y(x.size());
    for (std::int64_t row = 0; row < cells.rows; ++row) {
        for (std::int64_t column = 0; column < cells.columns; ++column) {
            const Point centre = cells.cell_centre(row, column);
            x[static_cast<std::size_t>(column)] = centre.x;
            y[static_cast<std::size_t>(column)] = centre.y;
        }
        to_working.apply(x, y, false);
        if (row == 0 && cells.columns > 1)
            here.cell_size = std::hypot(x.back() - x.front(), y.back() - y.front()) / (double(cells.columns) - 1);
        for (std::int64_t column = 0; column < cells.columns; ++column) {
            const double east = (x[static_cast<std::size_t>(column)] - grid.west) / grid.cell_size,
                         south = (grid.north - y[static_cast<std::size_t>(column)]) / grid.cell_size;
            if (!(east >= 0 && south >= 0 && east < double(grid.columns) && south < double(grid.rows))) continue;
            here.path.at(row, column) =
                std::as_const(working.path).at(static_cast<std::int64_t>(south), static_cast<std::int64_t>(east));
        }
    }
    return here;
}

std::string last_part(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

Sentence whole_percent(double share) {
    return numeral(number_text(std::round(100 * share), 3));
}

/// Elevations in feet that are read as metres make a slope of 17 degrees one of 45.
std::optional<Warning> doubt_unit(const LookedAt& working, const Prepared& prepared) {
    constexpr double k_carries = 10, k_steep = 42, k_foot = 0.3048;  // degrees, degrees, metres
    const gis::RasterInfo& file = prepared.ground.file;
    if (file.vertical_unit_stated || prepared.spec.terrain.vertical_unit != "auto") return std::nullopt;
    std::vector<double> slopes;
    working.path.values.for_each_stored([&](std::size_t cell, double on) {
        const auto at = static_cast<std::int64_t>(cell), columns = working.path.grid.columns;
        if (const double slope = on > 0 ? slope_deg(working.ground(), at / columns, at % columns) : 0;
            slope > k_carries)
            slopes.push_back(slope);
    });
    const double median = percentile(std::move(slopes), 0.5);
    if (!(median > k_steep)) return std::nullopt;
    const double in_feet = std::atan(k_foot * std::tan(median * std::numbers::pi / 180)) * 180 / std::numbers::pi;
    return Warning(worded("DTM {1}: slopes of {2}° ({3}° if feet): set terrain.vertical-unit",
                          {last_part(file.path), numeral(number_text(median, 2)), numeral(number_text(in_feet, 2))}));
}

Warnings warnings_of(const GroundDoubts& doubts, const LookedAt& here, const Prepared& prepared) {
    Warnings warnings;
    const double working = prepared.scene.grid.cell_size;
    const std::string file = last_part(prepared.ground.file.path);
    if (prepared.ground.file.data_type == "Byte")
        warnings.push_back(worded("DTM {1} has values 0 to 255 only: a hillshade?", {file}));
    if (const auto& blocks = doubts.blocks) {
        const double side = std::min(blocks->columns, blocks->rows);
        // Working cells as large as the blocks are right again.
        if (side * here.cell_size > 1.1 * working) {
            warnings.push_back({worded("DTM {3}: {1} % copied cells ({2} x {2}): resample bilinear",
                                       {whole_percent(blocks->share), numeral(number_text(side, 2)), file}),
                                true});
        }
    }
    if (const auto& terraces = doubts.terraces)
        warnings.push_back(worded(
            "DTM {4}: {1} % in steps of {2} m ({3}): use decimals",
            {whole_percent(terraces->share), numeral(number_text(terraces->step, 3)), here.at(terraces->place), file}));
    if (const auto& seam = doubts.seam)
        warnings.push_back(
            worded("DTM {4}: step of {1} m along {2} m ({3}): fit tiles",
                   {numeral(number_text(seam->height, 2)), numeral(number_text(seam->length * here.cell_size, 3)),
                    here.at(seam->place), file}));
    if (const auto& pits = doubts.pits) {
        warnings.push_back(
            {worded("DTM {4}: {1} pits at {2} m elevation ({3}): set terrain.nodata-value",
                    {numeral(grouped(pits->cells)), numeral(number_text(pits->value, 6)), here.at(pits->place), file}),
             true});
    }
    if (const auto& dam = doubts.dam)
        warnings.push_back(worded("DTM {3}: dam of {1} m across the path ({2}): open culverts",
                                  {numeral(number_text(dam->height, 2)), here.at(dam->place), file}));
    if (const auto& rough = doubts.rough)
        warnings.push_back(
            worded("DTM {4}: {1} % stands out {2} m ({3}): take bare ground",
                   {whole_percent(rough->share), numeral(number_text(rough->height, 2)), here.at(rough->place), file}));
    return warnings;
}

}  // namespace

Warnings doubt_ground(const SceneReading& reading, const Prepared& prepared) {
    const std::optional<Bounds> origin = origin_of(prepared.scene);
    const bool is_all_in_memory = !prepared.ground.on_demand && prepared.scene.terrain.values.is_tiled();
    if (!origin || is_all_in_memory) return {};  // a large map that is read whole costs more than this is worth
    const LookedAt working = on_working_grid(reading, prepared, *origin);
    const GridSpec& grid = working.ground().grid;
    const std::string& own_crs = grid.crs_wkt.empty() ? grid.crs_wkt : prepared.ground.file.crs_wkt;
    const gis::CrsTransform to_working(own_crs, grid.crs_wkt, prepared.ground.file.bounds);
    const std::optional<LookedAt> own = on_own_cells(reading, prepared, working, to_working);
    const LookedAt& here = own ? *own : working;
    Warnings warnings = warnings_of(ground_doubts(here.ground(), here.path, here.cell_size), here, prepared);
    if (const auto unit = doubt_unit(working, prepared)) warnings.insert(warnings.begin(), *unit);
    return warnings;
}

}  // namespace frana::app
