// SPDX-License-Identifier: Apache-2.0
#include "app/study/member_record.h"

#include <algorithm>
#include <cmath>

#include "analysis/ground_statistics.h"
#include "core/error.h"
#include "core/words/words.h"
#include "params/keys/result_rasters.h"
#include "simulation/run_check.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app::study {
namespace {

/// Why a run's figures are those of another event than its scene; empty: they are good.
std::string failure_of(const RunResult& result) {
    switch (result.stop_reason) {
        case StopReason::reached_no_data:
        case StopReason::non_finite:
        case StopReason::impossible_speed:
        case StopReason::volume_drift:
            return describe(result.stop_reason);
        default:
            return "";
    }
}

/// A map at the cells of a record, 0 where it has no value.
std::vector<float> values_at(const MemberRecord& record, const Raster& map) {
    std::vector<float> values;
    for (const CellRun& run : record.runs) {
        for (std::uint64_t cell = run.first; cell < run.first + run.count; ++cell) {
            const double value = map.values[cell];
            values.push_back(std::isnan(value) ? 0.0F : static_cast<float>(value));
        }
    }
    return values;
}

void add_cells(const ReachedPlaces& reached, MemberRecord& record) {
    const auto number = [](double value) { return static_cast<float>(value); };
    reached(RasterName::max_depth).values.for_each_stored([&](std::size_t cell, double depth) {
        if (std::isnan(depth)) return;
        if (record.runs.empty() || record.runs.back().first + record.runs.back().count != cell)
            record.runs.push_back({cell, 0});
        ++record.runs.back().count;
        record.of(Quantity::depth).push_back(number(depth));
        record.of(Quantity::arrival).push_back(number(reached(RasterName::arrival_time).values[cell]));
    });
    record.of(Quantity::velocity) = values_at(record, reached(RasterName::max_velocity));
}

}  // namespace

double value_of(const std::vector<Figure>& figures, const std::string& key) {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.key == key; });
    return found == figures.end() ? k_no_data : found->value;
}

CellWindow MemberRecord::place_in(const GridSpec& grid) const {
    const double column = (west - grid.west) / grid.cell_size, row = (grid.north - north) / grid.cell_size;
    constexpr double k_tolerance = 1e-3;  // of a cell: files round their origin
    const auto is_whole = [](double value) { return std::abs(value - std::round(value)) < k_tolerance; };
    if (!is_whole(column) || !is_whole(row) || std::abs(cell_size / grid.cell_size - 1) > 1e-9)
        throw Error(ErrorKind::input,
                    Problem{"has other cells than the study's scene", "member " + std::to_string(member), "", "",
                            "Set terrain.crs and terrain.cell-size in the scene"});
    return {static_cast<std::int64_t>(std::llround(row)), static_cast<std::int64_t>(std::llround(column)), rows,
            columns};
}

CellWindow MemberRecord::reached(const GridSpec& grid) const {
    constexpr std::int64_t k_far = std::numeric_limits<std::int64_t>::max();
    std::int64_t top = k_far, bottom = -k_far, left = k_far, right = -k_far;
    for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t) {
        top = std::min(top, row);
        bottom = std::max(bottom, row);
        left = std::min(left, column);
        right = std::max(right, column);
    });
    return bottom < top ? CellWindow{} : CellWindow{top, left, bottom - top + 1, right - left + 1};
}

Raster MemberRecord::raster(Quantity quantity, const GridSpec& grid) const {
    Raster raster(grid, k_no_data);
    const std::vector<float>& kept = of(quantity);
    for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
        if (row >= 0 && column >= 0 && row < grid.rows && column < grid.columns)
            raster.at(row, column) = static_cast<double>(kept[index]);
    });
    return raster;
}

MemberRecord empty_record(std::uint64_t member, const GridSpec& grid) {
    MemberRecord record;
    record.member = member;
    record.west = grid.west;
    record.north = grid.north;
    record.cell_size = grid.cell_size;
    record.columns = grid.columns;
    record.rows = grid.rows;
    return record;
}

MemberRecord without_cells(MemberRecord record) {
    record.runs = {};
    record.values = {};
    return record;
}

MemberRecord record_of(std::uint64_t member, const RunResult& result, const Scene& scene, double threshold,
                       const RecordExtras& extras) {
    MemberRecord record = empty_record(member, scene.grid);
    record.failure = failure_of(result);
    for (const RunValue& value : reported_values(result, scene, threshold))
        record.figures.push_back({value.key, value.title, value.unit, value.value});
    record.figures.push_back({"volume_m3", Sentence(worded("Volume")), "m3", result.volume_entered});
    record.end = {stop_word(result.stop_reason),
                  scene.time.end,
                  motion_at_end(result).front,
                  result.moving_fraction_limit,
                  left_fraction(result),
                  gap_contact(result, scene).cells > 0,
                  result.energy_error.value_or(k_no_data),
                  {}};
    record.engine_seconds = result.engine_seconds;
    record.particle_steps = result.particle_steps;
    const ReachedPlaces reached(result);
    add_cells(reached, record);
    if (extras.pressure) record.of(Quantity::pressure) = values_at(record, reached(RasterName::max_pressure));
    if (extras.momentum) record.of(Quantity::momentum) = values_at(record, reached(RasterName::max_momentum_flux));
    if (extras.scheme) record.of(Quantity::intensity) = values_at(record, intensity_classes(result, *extras.scheme));
    if (extras.deposit == Deposit::elevation_change)
        record.of(Quantity::deposit) = values_at(record, result.raster(RasterName::elevation_change));
    if (extras.deposit == Deposit::final_depth)
        record.of(Quantity::deposit) = values_at(
            record, result.depth_is_normal
                        ? vertical_depth(result.raster(RasterName::final_depth), result.raster(RasterName::bed))
                        : result.raster(RasterName::final_depth));
    return record;
}

}  // namespace frana::app::study
