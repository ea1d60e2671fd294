// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/outline_maps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/trace.h"
#include "app/study/member_record.h"
#include "app/study/statistics/sensitivity.h"

namespace frana::app::study {
namespace {

/// Distances are computed block by block, exact up to k_far cells: the ground between flows far apart costs nothing.
constexpr std::int64_t k_block = 1024, k_far = 512;

/// @param window of the cells and k_far around them, as far as any member comes
std::vector<double> distances_in(const MemberRecord& record, const GridSpec& grid, const CellWindow& window,
                                 Quantity quantity, double threshold, const std::vector<std::size_t>& cells) {
    const auto columns = static_cast<std::size_t>(window.columns + 2);  // with a border where nothing comes
    std::vector<char> inside(columns * static_cast<std::size_t>(window.rows + 2));
    const auto place = [&](std::int64_t row, std::int64_t column) {
        return static_cast<std::size_t>(row - window.row + 1) * columns +
               static_cast<std::size_t>(column - window.column + 1);
    };
    const std::vector<float>& of_member = record.of(quantity);
    record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
        if (row < window.row || column < window.column || row >= window.row + window.rows ||
            column >= window.column + window.columns)
            return;
        inside[place(row, column)] = static_cast<double>(of_member[index]) > threshold ? 1 : 0;
    });
    const std::vector<double> all = distances_from_rim(inside, columns);
    std::vector<double> distances;
    for (const std::size_t cell : cells)
        distances.push_back(
            all[place(static_cast<std::int64_t>(cell) / grid.columns, static_cast<std::int64_t>(cell) % grid.columns)]);
    return distances;
}

/// Divides cells into lots that lie in one block each, of at most `most`.
std::vector<std::vector<std::size_t>> lots_of(const std::vector<std::size_t>& cells, const GridSpec& grid,
                                              std::size_t most) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> blocks;
    for (const std::size_t cell : cells) {
        const auto at = static_cast<std::int64_t>(cell);
        blocks[{at / grid.columns / k_block, at % grid.columns / k_block}].push_back(cell);
    }
    std::vector<std::vector<std::size_t>> lots;
    for (const auto& [place, all] : blocks)
        for (std::size_t first = 0; first < all.size(); first += most)
            lots.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(first),
                              all.begin() + static_cast<std::ptrdiff_t>(std::min(first + most, all.size())));
    return lots;
}

/// The block of such a lot and k_far around it, within `limits`.
CellWindow window_around(const std::vector<std::size_t>& cells, const GridSpec& grid, const CellWindow& limits) {
    const auto at = static_cast<std::int64_t>(cells.front());
    const auto part = [](std::int64_t cell, std::int64_t first, std::int64_t count) {
        const std::int64_t block = cell / k_block * k_block;
        const std::int64_t low = std::max(first, block - k_far),
                           high = std::min(first + count, block + k_block + k_far);
        return std::pair(low, high - low);
    };
    CellWindow window;
    std::tie(window.row, window.rows) = part(at / grid.columns, limits.row, limits.rows);
    std::tie(window.column, window.columns) = part(at % grid.columns, limits.column, limits.columns);
    return window;
}

}  // namespace

std::vector<double> distances_from_outline(const FinishedMembers& members, Quantity quantity, double threshold,
                                           const GridSpec& grid, std::size_t cell) {
    const auto at = static_cast<std::int64_t>(cell);
    const CellWindow window =
        window_of_both(reached_window(members, grid), {at / grid.columns, at % grid.columns, 1, 1});
    std::vector<double> all;
    for (const RecordPlace& record : members.records)
        all.push_back(distances_in(require_record(record), grid, window, quantity, threshold, {cell}).front());
    return all;
}

std::vector<Raster> outline_fractions(const FinishedMembers& members, const DesignPoints& points, Quantity quantity,
                                      double threshold, const GridSpec& grid) {
    std::vector<Raster> fractions(points.nominal.size(), Raster(grid, k_no_data));
    std::vector<std::size_t> rim;  // cells that some members reach and others do not
    for_each_reached_cell(members, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        const auto exceeds = [&](float value) { return static_cast<double>(value) > threshold; };
        const auto count = static_cast<std::size_t>(std::count_if(values.begin(), values.end(), exceeds));
        if (count > 0 && count < values.size()) rim.push_back(cell);
    });
    const CellWindow reached = reached_window(members, grid);
    const std::size_t at_once = std::max<std::size_t>(
        1, CellStore::k_budget_bytes / (sizeof(double) * std::max<std::size_t>(1, members.size())));
    for (const std::vector<std::size_t>& cells : lots_of(rim, grid, at_once)) {
        const CellWindow window = window_around(cells, grid, reached);
        std::vector<std::vector<double>> distances(cells.size());
        for (const RecordPlace& record : members.records) {
            const std::vector<double> of_member =
                distances_in(require_record(record), grid, window, quantity, threshold, cells);
            for (std::size_t i = 0; i < cells.size(); ++i) distances[i].push_back(of_member[i]);
        }
        const std::vector<Chaos> all = openturns().chaos(points, distances, {});
        for (std::size_t i = 0; i < cells.size(); ++i)
            for (std::size_t k = 0; k < fractions.size() && all[i].q2 >= k_least_q2; ++k)
                fractions[k].values[cells[i]] = all[i].first_order[k];
    }
    return fractions;
}

}  // namespace frana::app::study
