// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_in.h"

#include <cpl_string.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_source.h"
#include "gis/raster/raster_warp.h"

namespace frana::gis {
namespace {

// Cells within a thousandth of a cell of each other are the same cells: files round their corners.
constexpr double k_same_place_cells = 1e-3;
// A source up to this much finer than the grid is interpolated: an average over about one cell would only smooth it.
constexpr double k_average_from = 1.25;
constexpr int k_read_at_once = 4'000'000;
// Ground that rises by two cells from one cell to the next (63 degrees) is a wall.
constexpr double k_wall_cells = 2;

/// Returns the grid's upper left corner in the source's rows and columns, if the cells of both coincide. The source may
/// be stored from the south.
bool cells_coincide(const RasterSource& source, const CrsTransform& to_grid, const GridSpec& grid, Point& corner) {
    const GeoTransform& g = source.geo_transform();
    if (!to_grid.is_identity() || source.info().rotated || g[1] <= 0) return false;
    const double down = g[5] < 0 ? 1 : -1;  // rows of the source per row of the grid
    const auto far = [&](Point map, double column, double row) {
        const Point cell = source.cell_from_map(map);
        return std::abs(cell.x - column) > k_same_place_cells || std::abs(cell.y - row) > k_same_place_cells;
    };
    const Point place = source.cell_from_map({grid.west, grid.north});
    corner = {std::round(place.x), std::round(place.y)};
    return !far({grid.west, grid.north}, corner.x, corner.y) &&
           !far({grid.east(), grid.south()}, corner.x + static_cast<double>(grid.columns),
                corner.y + down * static_cast<double>(grid.rows));
}

void copy_cells(const RasterSource& source, Point corner, double unit, Raster& target) {
    const GridSpec& grid = target.grid;
    const bool from_south = source.geo_transform()[5] > 0;
    const auto c0 = static_cast<std::int64_t>(corner.x);
    const auto r0 = static_cast<std::int64_t>(corner.y) - (from_south ? grid.rows : 0);
    const std::int64_t first_column = std::max<std::int64_t>(c0, 0), first_row = std::max<std::int64_t>(r0, 0);
    const Window window{static_cast<int>(first_column), static_cast<int>(first_row),
                        static_cast<int>(std::min(source.info().columns, c0 + grid.columns) - first_column),
                        static_cast<int>(std::min(source.info().rows, r0 + grid.rows) - first_row)};
    if (window.empty()) return;
    const int rows_at_once = std::max(1, k_read_at_once / window.columns);
    for (int start = 0; start < window.rows; start += rows_at_once) {
        const int rows = std::min(rows_at_once, window.rows - start);
        const std::vector<double> values = source.read({window.column, window.row + start, window.columns, rows}, unit);
        for (int row = 0; row < rows; ++row) {
            const std::int64_t down = window.row + start + row - r0;
            const std::int64_t to = from_south ? grid.rows - 1 - down : down;
            std::copy_n(values.begin() + static_cast<std::int64_t>(row) * window.columns, window.columns,
                        target.values.begin() + static_cast<std::ptrdiff_t>(target.index(to, window.column - c0)));
        }
    }
}

struct Method {
    GDALResampleAlg algorithm;
    const char* name;
};

Method method_for(Resampling wanted, Point source_cells_per_cell) {
    const double ratio = std::sqrt(source_cells_per_cell.x * source_cells_per_cell.y);
    switch (wanted) {
        case Resampling::nearest:
            return {GRA_NearestNeighbour, "nearest"};
        case Resampling::bilinear:
            return {GRA_Bilinear, "bilinear"};
        case Resampling::cubic:
            return {GRA_Cubic, "cubic"};
        case Resampling::average:
            return {GRA_Average, "average"};
        case Resampling::automatic:
            break;
    }
    return ratio > k_average_from ? Method{GRA_Average, "average"} : Method{GRA_Bilinear, "bilinear"};
}

/// Adds the file's name to errors inside a transform, which do not contain it.
[[noreturn]] void rethrow_naming(const Place& path, const Error& error) {
    std::vector<Problem> problems = error.problems();
    for (Problem& problem : problems) {
        if (problem.where.empty()) problem.where = path;
    }
    throw Error(error.kind(), std::move(problems));
}

std::optional<Sentence> unit_warning(const RasterInfo& info, const VerticalUnit& unit, const std::string& crs) {
    if (!unit.known) {
        return worded("{1}: vertical unit \"{2}\" unknown, not converted", {info.path, unit.name});
    }
    if (!unit.stated && std::abs(metres_per_unit(crs) - 1) > 1e-9) {
        return worded("{1}: vertical unit not stated, taken as metres: set the vertical unit", {info.path});
    }
    return {};
}

/// The operation is chosen for the grid's surroundings, not for the whole extent of the file.
CrsTransform transform_to_grid(const std::string& source_crs, const GridSpec& grid) {
    if (grid.crs_wkt.empty()) return {"", ""};
    return {source_crs, grid.crs_wkt, CrsTransform(grid.crs_wkt, source_crs, grid.bounds()).around(grid.bounds())};
}

/// The file's CRS, or the one that replaces it. Throws Error(input) if one is needed and there is none.
std::string crs_of(const RasterSource& source, const GridSpec& target, const std::string& source_crs_override) {
    const std::string crs = source_crs_override.empty() ? source.info().crs_wkt : source_crs_override;
    if (crs.empty() && !target.crs_wkt.empty()) {
        throw Error(ErrorKind::input,
                    Problem{"the raster names no coordinate reference system", source.info().path, "", "",
                            "Assign one (gdal_edit.py -a_srs EPSG:32632 FILE), or use crs = local throughout"});
    }
    return crs;
}

VerticalUnit unit_of(const RasterSource& source, const std::string& source_crs, const std::string& vertical_unit) {
    return vertical_unit == "auto" ? vertical_unit_of(source.info().band_unit, source_crs)
                                   : vertical_unit_named(vertical_unit);
}

std::string name_of(const std::string& path, const std::string& key) {
    return key.empty() ? path : key + ": " + path;
}

}  // namespace

/// A file, and how its values come to the cells of a grid.
struct OntoGrid {
    std::string where;
    GridSpec grid;
    RasterSource source;
    CrsTransform to_grid{"", ""};
    double unit = 1;
    std::optional<Point> corner{};  // of the grid in the file's cells; none: it is warped
    GDALResampleAlg algorithm = GRA_NearestNeighbour;
    Point scale{1, 1};
    RasterRead known{};

    /// @param place of problems of the file, `name` of those of its transform
    OntoGrid(const std::string& file, const Place& place, std::string name, const GridSpec& target,
             const std::string& source_crs_override, Resampling resampling, const std::string& vertical_unit,
             std::optional<double> nodata_value)
        : where(std::move(name)), grid(target), source(file, place) {
        if (nodata_value) source.declare_nodata(*nodata_value);
        const std::string crs = crs_of(source, target, source_crs_override);
        try {
            to_grid = transform_to_grid(crs, target);
            known.transform = to_grid.info();
            const VerticalUnit units = unit_of(source, crs, vertical_unit);
            unit = units.metres;
            if (auto warning = unit_warning(source.info(), units, crs)) known.warnings.push_back(std::move(*warning));
            Point at;
            if (cells_coincide(source, to_grid, target, at)) {
                corner = at;
                known.resampling_used = "exact copy";
                return;
            }
            scale = RasterWarp(source, to_grid, GRA_NearestNeighbour, unit).source_cells_per_cell(target);
            const Method method = method_for(resampling, scale);
            algorithm = method.algorithm;
            known.resampling_used = method.name;
        } catch (const Error& error) {
            rethrow_naming(where, error);
        }
    }
};

struct RasterOnDemand::Parts : OntoGrid {
    using OntoGrid::OntoGrid;
};

RasterOnDemand::RasterOnDemand(const std::string& path, const GridSpec& target, const std::string& source_crs_override,
                               Resampling resampling, const std::string& vertical_unit,
                               std::optional<double> nodata_value, const Place& where) {
    const GdalSession session;
    const std::string name = name_of(path, where);
    parts_ =
        std::make_unique<Parts>(path, name, name, target, source_crs_override, resampling, vertical_unit, nodata_value);
}

RasterOnDemand::~RasterOnDemand() = default;

const RasterRead& RasterOnDemand::known() const noexcept {
    return parts_->known;
}

std::vector<Sentence> RasterOnDemand::suspicions() const {
    const std::optional<Sentence> warning = parts_->source.suspicion();
    return warning ? std::vector{*warning} : std::vector<Sentence>();
}

void RasterOnDemand::read(const CellWindow& window, double* values) const {
    const Parts& p = *parts_;
    const GdalSession session;
    try {
        const GridSpec part = part_of(p.grid, window);
        if (!p.corner) {
            RasterWarp(p.source, p.to_grid, p.algorithm, p.unit).fill_part(part, p.scale, values);
            return;
        }
        Raster cells;
        cells.grid = part;
        cells.values = std::vector<double>(static_cast<std::size_t>(part.cell_count()), k_no_data);
        const bool from_south = p.source.geo_transform()[5] > 0;
        const auto row = static_cast<double>(window.row);
        copy_cells(p.source,
                   {p.corner->x + static_cast<double>(window.column), p.corner->y + (from_south ? -row : row)}, p.unit,
                   cells);
        std::copy(cells.values.begin(), cells.values.end(), values);
    } catch (const Error& error) {
        rethrow_naming(p.where, error);
    }
}

RasterRead read_raster_on(const std::string& path, const GridSpec& target, const std::string& source_crs_override,
                          Resampling resampling, const std::string& vertical_unit, std::optional<double> nodata_value,
                          const Place& where) {
    const GdalSession session;
    const OntoGrid file(path, where.empty() ? Place(path) : where, name_of(path, where), target, source_crs_override,
                        resampling, vertical_unit, nodata_value);
    RasterRead read = file.known;
    read.raster = Raster(target, k_no_data);
    try {
        if (file.corner)
            copy_cells(file.source, *file.corner, file.unit, read.raster);
        else
            RasterWarp(file.source, file.to_grid, file.algorithm, file.unit).fill(read.raster);
        if (auto warning = file.source.suspicion()) read.warnings.push_back(std::move(*warning));
        read.zero_rim_cells = file.source.zero_rim(k_wall_cells * target.cell_size, file.unit);
    } catch (const Error& error) {
        rethrow_naming(file.where, error);
    }
    read.nodata_cells = std::count_if(read.raster.values.begin(), read.raster.values.end(),
                                      [](double value) { return std::isnan(value); });
    return read;
}

Raster read_result_raster(const std::string& path, int band) {
    const GdalSession session;
    const RasterSource source(path, path, true, band);
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
    if (grid.cell_count() <= CellValues::k_most_dense) {
        Raster raster;
        raster.grid = grid;
        const Window whole{0, 0, static_cast<int>(info.columns), static_cast<int>(info.rows)};
        raster.values = source.read_plain(whole, info.vertical_scale_to_metres);
        return raster;
    }
    // What a sparse file does not contain is no data, or 0 where the file names no such value.
    Raster raster(grid, info.has_nodata ? k_no_data : 0);
    constexpr std::int64_t k_at_once = 4 * CellValues::k_side;
    for (std::int64_t row = 0; row < grid.rows; row += k_at_once) {
        for (std::int64_t column = 0; column < grid.columns; column += k_at_once) {
            const Window window{static_cast<int>(column), static_cast<int>(row),
                                static_cast<int>(std::min(k_at_once, grid.columns - column)),
                                static_cast<int>(std::min(k_at_once, grid.rows - row))};
            if (!source.holds_any(window)) continue;
            const std::vector<double> values = source.read_plain(window, info.vertical_scale_to_metres);
            for (std::size_t k = 0; k < values.size(); ++k)
                if (!std::isnan(values[k]))
                    raster.at(row + static_cast<std::int64_t>(k) / window.columns,
                              column + static_cast<std::int64_t>(k) % window.columns) = values[k];
        }
    }
    return raster;
}

std::int64_t fill_nodata(Raster& raster, double max_distance_cells) {
    if (std::none_of(raster.values.begin(), raster.values.end(), [](double v) { return std::isnan(v); })) return 0;
    const GdalSession session;
    std::vector<double> filled = raster.values;
    const GdalDataset dataset =
        wrap_values(filled.data(), static_cast<int>(raster.grid.columns), static_cast<int>(raster.grid.rows));
    CPLStringList options;
    options.SetNameValue("TEMP_FILE_DRIVER", "MEM");
    if (GDALFillNodata(GDALGetRasterBand(dataset.get(), 1), nullptr, max_distance_cells, 0, 0, options.List(), nullptr,
                       nullptr) != CE_None) {
        throw Error(ErrorKind::input, Problem{"cells without data cannot be filled: " + session.last_message(), "", "",
                                              "", "Use nodata-policy = stop or wall"});
    }
    // GDAL computes in single precision; cells that had data keep it to the last bit.
    std::int64_t count = 0;
    for (std::size_t i = 0; i < filled.size(); ++i) {
        if (!std::isnan(raster.values[i]) || std::isnan(filled[i])) continue;
        raster.values[i] = filled[i];
        ++count;
    }
    return count;
}

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
