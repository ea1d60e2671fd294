// SPDX-License-Identifier: Apache-2.0
#include "app/publish/result_extent.h"

#include <algorithm>
#include <cmath>

#include "analysis/trace.h"
#include "app/store/scene_identity.h"
#include "core/geometry.h"
#include "params/keys/output_parameters.h"

namespace frana::app {
namespace {

// As much as a map page shows, in multiples of the longer side.
constexpr double k_page_width = 1.6, k_page_height = 1.4;
constexpr std::int64_t k_least_margin = 16;  // [cells]

/// A rectangle of cells, [row0, row1) x [column0, column1).
struct Box {
    std::int64_t row0, row1 = 0, column0, column1 = 0;

    explicit Box(const GridSpec& grid) : row0(grid.rows), column0(grid.columns) {}
    [[nodiscard]] bool empty() const noexcept { return row1 <= row0 || column1 <= column0; }
    void include(std::int64_t row, std::int64_t column) {
        row0 = std::min(row0, row);
        row1 = std::max(row1, row + 1);
        column0 = std::min(column0, column);
        column1 = std::max(column1, column + 1);
    }
    void include(const Raster& raster) {
        raster.values.for_each_stored([&](std::size_t cell, double value) {
            const auto n = static_cast<std::int64_t>(cell);
            if (!std::isnan(value)) include(n / raster.grid.columns, n % raster.grid.columns);
        });
    }
    void include(const GridSpec& grid, const Bounds& area) {
        const auto cell = [&](double metres, std::int64_t count) {
            return static_cast<std::int64_t>(
                std::clamp(std::floor(metres / grid.cell_size), 0.0, static_cast<double>(count - 1)));
        };
        include(cell(grid.north - area.north, grid.rows), cell(area.west - grid.west, grid.columns));
        include(cell(grid.north - area.south, grid.rows), cell(area.east - grid.west, grid.columns));
    }
    void widen(const GridSpec& grid) {
        const auto longer = static_cast<double>(std::max(row1 - row0, column1 - column0));
        const auto widened = [&](std::int64_t& from, std::int64_t& to, double page, std::int64_t count) {
            const auto missing = static_cast<std::int64_t>(page * longer) - (to - from);
            const std::int64_t by = std::max(k_least_margin, (missing + 1) / 2);
            from = std::max<std::int64_t>(0, from - by);
            to = std::min(count, to + by);
        };
        widened(row0, row1, k_page_height, grid.rows);
        widened(column0, column1, k_page_width, grid.columns);
    }
};

bool shows_reached_only(const Prepared& prepared) {
    const std::string& extent = prepared.spec.output.extent;
    return extent == "reached" || (extent == "auto" && prepared.scene.grid.cell_count() > k_largest_whole_map);
}

}  // namespace

std::optional<CellWindow> reached_window(const Prepared& prepared, const RunResult& result) {
    const bool finished = result.stop_reason != StopReason::requested && result.run_problems.empty();
    if (!finished || !shows_reached_only(prepared)) return std::nullopt;
    const GridSpec& grid = result.max_depth.grid;
    Box box(grid);
    for (const Raster* raster :
         {&result.max_depth, &result.release, &result.eroded_depth, &result.deposited_depth, &result.jump_height})
        box.include(*raster);
    if (prepared.scar) {
        for (const PolygonFeature& feature : prepared.scar->features) box.include(grid, bounds(feature.parts));
    }
    if (box.empty()) return std::nullopt;
    box.widen(grid);
    if (box.row1 - box.row0 == grid.rows && box.column1 - box.column0 == grid.columns) return std::nullopt;
    return CellWindow{box.row0, box.column0, box.row1 - box.row0, box.column1 - box.column0};
}

RunResult cut_to(const RunResult& result, const CellWindow& window) {
    RunResult part = result;
    for (Raster* raster : {&part.bed, &part.release, &part.max_depth, &part.max_velocity, &part.max_pressure,
                           &part.arrival_time, &part.final_depth, &part.max_flux, &part.max_head, &part.eroded_depth,
                           &part.deposited_depth, &part.jump_height})
        *raster = frana::cut_to(*raster, window);
    for (NamedRaster& raster : part.more) raster.values = frana::cut_to(raster.values, window);
    return part;
}

Prepared cut_to(const Prepared& prepared, const CellWindow& window) {
    Prepared part = prepared;
    part.identity = data_identity(prepared);
    part.scene.terrain = frana::cut_to(prepared.scene.terrain, window);
    return part;
}

}  // namespace frana::app
