// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_warp.h"

#include <cpl_string.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

constexpr double k_warped_at_once = 4e6;     // 36 MB with the mask
constexpr double k_kernel_radius_cells = 3;  // cubic reaches 2 cells; one more for rounding
constexpr double k_approximation_cells = 0.01;

/// Points in a cell at which an average samples the surface, along each side. If the cell contains whole square source
/// cells, one for each, which is their plain mean; else two or more, so that every source cell has almost equal weight.
int points_per_side(Point source_cells_per_cell) {
    constexpr double k_whole = 1e-9, k_most_points = 1000;
    const auto [x, y] = source_cells_per_cell;
    const bool whole = std::abs(x - std::round(x)) < k_whole * x && std::abs(x - y) < k_whole * x;
    const double wanted = whole ? std::round(x) : std::ceil(2 * std::max(x, y) * (1 - k_whole));
    return static_cast<int>(std::clamp(wanted, 1.0, k_most_points));
}

}  // namespace

/// The transformer's data. GDAL reads the head to distinguish its own transformers from others.
struct RasterWarp::Strip {
    GDALTransformerInfo head{};
    const RasterWarp* warp = nullptr;
    const GridSpec* grid = nullptr;
    Window window;
};

RasterWarp::RasterWarp(const RasterSource& source, const CrsTransform& to_grid, GDALResampleAlg algorithm, double unit)
    : source_(source), to_grid_(to_grid), algorithm_(algorithm), unit_(unit) {}

int RasterWarp::transform(void* self, int to_source, int count, double* x, double* y, double*, int* good) {
    const Strip& strip = *static_cast<const Strip*>(self);
    const RasterWarp& warp = *strip.warp;
    const GridSpec& grid = *strip.grid;
    const auto n = static_cast<std::size_t>(count);
    const std::span<double> xs(x, n), ys(y, n);
    for (std::size_t i = 0; i < n; ++i) {
        const Point map = to_source ? Point{grid.west + x[i] * grid.cell_size, grid.north - y[i] * grid.cell_size}
                                    : warp.source_.map_from_cell({x[i] + strip.window.column, y[i] + strip.window.row});
        x[i] = map.x;
        y[i] = map.y;
    }
    warp.to_grid_.apply(xs, ys, to_source != 0);
    for (std::size_t i = 0; i < n; ++i) {
        Point cell;
        if (to_source) {
            cell = warp.source_cell({x[i], y[i]});
            cell.x -= strip.window.column;
            cell.y -= strip.window.row;
        } else {
            cell = {(x[i] - grid.west) / grid.cell_size, (grid.north - y[i]) / grid.cell_size};
        }
        good[i] = std::isfinite(cell.x) && std::isfinite(cell.y) ? TRUE : FALSE;
        x[i] = good[i] ? cell.x : HUGE_VAL;
        y[i] = good[i] ? cell.y : HUGE_VAL;
    }
    return TRUE;
}

Point RasterWarp::source_cell(Point map) const noexcept {
    // A raster across the antimeridian runs from 179 to 181; PROJ returns -179.
    if (const double turn = to_grid_.source_turn(); turn > 0) {
        const Bounds& box = source_.info().bounds;
        map.x += turn * std::round(((box.west + box.east) / 2 - map.x) / turn);
    }
    return source_.cell_from_map(map);
}

Point RasterWarp::source_cells_per_cell(const GridSpec& grid) const {
    const Point centre = grid.cell_centre(grid.rows / 2, grid.columns / 2);
    const double half = grid.cell_size / 2;
    const auto cell_at = [&](double dx, double dy) {
        return source_cell(to_grid_.inverse({centre.x + dx, centre.y + dy}));
    };
    const Point east = cell_at(half, 0), west = cell_at(-half, 0), north = cell_at(0, half), south = cell_at(0, -half);
    return {std::hypot(east.x - west.x, east.y - west.y), std::hypot(north.x - south.x, north.y - south.y)};
}

Window RasterWarp::source_window(const GridSpec& strip, Point scale) const {
    constexpr int k_steps = 20;
    double west = std::numeric_limits<double>::infinity(), east = -west, top = west, bottom = -west;
    for (int i = 0; i <= k_steps; ++i) {
        const double t = static_cast<double>(i) / k_steps;
        const double x = strip.west + t * (strip.east() - strip.west);
        const double y = strip.south() + t * (strip.north - strip.south());
        const Point rim[] = {{x, strip.north}, {x, strip.south()}, {strip.west, y}, {strip.east(), y}};
        for (const Point& map : rim) {
            double mx = map.x, my = map.y;
            if (!to_grid_.apply({&mx, 1}, {&my, 1}, true)) continue;
            const Point cell = source_cell({mx, my});
            west = std::min(west, cell.x);
            east = std::max(east, cell.x);
            top = std::min(top, cell.y);
            bottom = std::max(bottom, cell.y);
        }
    }
    if (!std::isfinite(west)) return {};
    const double pad_x = k_kernel_radius_cells * std::max(1.0, scale.x),
                 pad_y = k_kernel_radius_cells * std::max(1.0, scale.y);
    const auto columns = static_cast<double>(source_.info().columns), rows = static_cast<double>(source_.info().rows);
    const auto whole = [](double value, double limit) { return static_cast<int>(std::clamp(value, 0.0, limit)); };
    Window window;
    window.column = whole(std::floor(west - pad_x), columns);
    window.row = whole(std::floor(top - pad_y), rows);
    window.columns = whole(std::ceil(east + pad_x), columns) - window.column;
    window.rows = whole(std::ceil(bottom + pad_y), rows) - window.row;
    return window;
}

void RasterWarp::fill_strip(const GridSpec& grid, Point scale, double* values, bool exactly) const {
    Strip strip;
    std::memcpy(strip.head.abySignature, "FRAN", 4);
    strip.head.pszClassName = "frana";
    strip.warp = this;
    strip.grid = &grid;
    strip.window = source_window(grid, scale);
    std::fill_n(values, grid.cell_count(), k_no_data);
    if (strip.window.empty()) return;

    std::vector<double> window_values = source_.read(strip.window, unit_);
    const GdalSession session;
    const GdalDataset from = wrap_values(window_values.data(), strip.window.columns, strip.window.rows);
    const GdalDataset to = wrap_values(values, static_cast<int>(grid.columns), static_cast<int>(grid.rows));
    const std::unique_ptr<void, void (*)(void*)> approximate(
        GDALCreateApproxTransformer(&RasterWarp::transform, &strip, k_approximation_cells),
        GDALDestroyApproxTransformer);

    const std::unique_ptr<GDALWarpOptions, void (*)(GDALWarpOptions*)> options(GDALCreateWarpOptions(),
                                                                               GDALDestroyWarpOptions);
    options->hSrcDS = from.get();
    options->hDstDS = to.get();
    options->eResampleAlg = algorithm_ == GRA_Average ? GRA_Bilinear : algorithm_;
    options->eWorkingDataType = GDT_Float64;
    GDALWarpInitDefaultBandMapping(options.get(), 1);
    GDALWarpInitSrcNoDataReal(options.get(), k_no_data);
    GDALWarpInitDstNoDataReal(options.get(), k_no_data);
    exactly = exactly || to_grid_.is_identity();
    options->pfnTransformer = exactly ? &RasterWarp::transform : GDALApproxTransform;
    options->pTransformerArg = exactly ? static_cast<void*>(&strip) : approximate.get();
    // The kernel's width must follow from the cells alone, not from the division into strips.
    const auto kernel = [](double cells) { return shortest_text(cells > 1 ? 1 / cells : 1); };
    char** words = nullptr;
    words = CSLSetNameValue(words, "INIT_DEST", "NO_DATA");
    words = CSLSetNameValue(words, "XSCALE", kernel(scale.x).c_str());
    words = CSLSetNameValue(words, "YSCALE", kernel(scale.y).c_str());
    // Other threads would each need a copy of the transformer, which only GDAL's own can make.
    words = CSLSetNameValue(words, "NUM_THREADS", "1");
    options->papszWarpOptions = words;

    GDALWarpOperation operation;
    if (operation.Initialize(options.get()) != CE_None ||
        operation.ChunkAndWarpImage(0, 0, static_cast<int>(grid.columns), static_cast<int>(grid.rows)) != CE_None) {
        throw Error(ErrorKind::input, Problem{"the raster cannot be resampled to the grid: " + session.last_message(),
                                              source_.info().path, "", "", "Check its coordinate reference system"});
    }
}

void RasterWarp::average_strip(const GridSpec& strip, Point scale, int points, double* values, bool exactly) const {
    GridSpec fine = strip;
    fine.cell_size /= points;
    fine.columns *= points;
    fine.rows *= points;
    std::vector<double> surface(fine.cell_count());
    fill_strip(fine, {scale.x / points, scale.y / points}, surface.data(), exactly);
    for (std::int64_t row = 0; row < strip.rows; ++row) {
        for (std::int64_t column = 0; column < strip.columns; ++column) {
            double sum = 0;
            int count = 0;
            for (int a = 0; a < points; ++a) {
                const double* const at = surface.data() + (row * points + a) * fine.columns + column * points;
                for (int b = 0; b < points; ++b) {
                    if (std::isnan(at[b])) continue;
                    sum += at[b];
                    ++count;
                }
            }
            values[row * strip.columns + column] = count > 0 ? sum / count : k_no_data;
        }
    }
}

void RasterWarp::fill_part(const GridSpec& part, Point scale, double* values) const {
    if (algorithm_ == GRA_Average) {
        average_strip(part, scale, points_per_side(scale), values, true);
    } else {
        fill_strip(part, scale, values, true);
    }
}

void RasterWarp::fill(Raster& target) const {
    const GridSpec& grid = target.grid;
    const Point scale = source_cells_per_cell(grid);
    const int points = algorithm_ == GRA_Average ? points_per_side(scale) : 1;
    const double cells_per_row = static_cast<double>(grid.columns) * std::max({1.0, scale.x, double(points)}) *
                                 std::max({1.0, scale.y, double(points)});
    const auto rows_at_once =
        static_cast<std::int64_t>(std::clamp(k_warped_at_once / cells_per_row, 1.0, static_cast<double>(grid.rows)));
    for (std::int64_t row = 0; row < grid.rows; row += rows_at_once) {
        GridSpec strip = grid;
        strip.north = grid.north - static_cast<double>(row) * grid.cell_size;
        strip.rows = std::min(rows_at_once, grid.rows - row);
        double* const values = target.values.data() + target.index(row, 0);
        if (algorithm_ == GRA_Average) {
            average_strip(strip, scale, points, values);
        } else {
            fill_strip(strip, scale, values);
        }
    }
}

}  // namespace frana::gis
