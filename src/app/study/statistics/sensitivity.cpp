// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "analysis/trace.h"
#include "app/study/member_record.h"

namespace frana::app::study {
namespace {

/// Mean ranks: equal values share the mean of theirs.
std::vector<double> ranks_of(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]]) ++last;
        for (std::size_t i = first; i <= last; ++i) ranks[order[i]] = static_cast<double>(first + last) / 2;
        first = last + 1;
    }
    return ranks;
}

/// eta: root of the variance between the means of the classes over all variance.
double correlation_ratio(const std::vector<double>& classes, const std::vector<double>& y) {
    std::map<double, std::pair<double, double>> sums;  // of values, and count
    for (std::size_t i = 0; i < y.size(); ++i) {
        sums[classes[i]].first += y[i];
        sums[classes[i]].second += 1;
    }
    const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
    double between = 0, all = 0;
    for (const auto& [name, sum] : sums) between += sum.second * std::pow(sum.first / sum.second - mean, 2);
    for (const double value : y) all += (value - mean) * (value - mean);
    if (!(all > 0)) return std::numeric_limits<double>::quiet_NaN();
    return std::sqrt(std::min(1.0, between / all));
}

/// Fisher's transformation with the variance of Bonett and Wright (2000) for Spearman's rho.
Interval rank_interval(double rho, std::size_t count) {
    if (count <= 3 || std::abs(rho) >= 1) return {rho, count <= 3 ? -1.0 : rho, count <= 3 ? 1.0 : rho};
    const double z = std::atanh(rho), half = k_normal * std::sqrt((1 + rho * rho / 2) / static_cast<double>(count - 3));
    return {rho, std::tanh(z - half), std::tanh(z + half)};
}

bool all_different(const std::vector<double>& values) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

}  // namespace

std::vector<KeySensitivity> elementary_effects(const DesignPoints& points, const std::vector<double>& output,
                                               std::size_t groups) {
    const auto count = static_cast<double>(groups);
    std::vector<KeySensitivity> all(points.nominal.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        double mean = 0, absolute = 0, squares = 0;
        for (std::size_t i = 0; i < groups; ++i) {
            const std::size_t moved = (k + 1) * groups + i;
            const double change =
                (output[moved] - output[i]) * (points.places[moved][k] > points.places[i][k] ? 1 : -1);
            mean += change / count;
            absolute += std::abs(change) / count;
            squares += change * change;
        }
        // Of the absolute values the squares are the same.
        const auto deviation = [&](double of) {
            return std::sqrt(std::max(0.0, squares - count * of * of) / (count - 1));
        };
        const double half = k_normal * deviation(absolute) / std::sqrt(count);
        all[k].effect = Interval{absolute, absolute - half, absolute + half};
        all[k].effect_scatter = deviation(mean);
    }
    return all;
}

Places rank_places(const DesignPoints& points) {
    Places places(points.numbers.size(), std::vector<double>(points.nominal.size()));
    for (std::size_t k = 0; k < points.nominal.size(); ++k) {
        const std::vector<double> ranks = ranks_of(column_of(points.numbers, k));
        for (std::size_t i = 0; i < ranks.size(); ++i)
            places[i][k] = (ranks[i] + 0.5) / static_cast<double>(ranks.size());
    }
    return places;
}

std::vector<KeySensitivity> rank_correlations(const DesignPoints& points, const std::vector<double>& output) {
    std::vector<KeySensitivity> all(points.nominal.size());
    const std::vector<double> ranks = ranks_of(output), alike(output.size(), 1);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::vector<double> column = column_of(points.numbers, k);
        if (points.nominal[k] && all_different(column)) continue;
        const double value =
            points.nominal[k] ? correlation_ratio(column, ranks) : correlation(ranks_of(column), ranks, alike);
        if (std::isnan(value)) continue;
        constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
        all[k].rank_correlation =
            points.nominal[k] ? Interval{value, k_none, k_none} : rank_interval(value, output.size());
    }
    return all;
}

bool are_correlated(const DesignPoints& points) {
    const double most = 4 / std::sqrt(static_cast<double>(points.numbers.size()));
    for (std::size_t a = 0; a < points.nominal.size(); ++a) {
        if (points.nominal[a]) continue;
        const std::vector<KeySensitivity> with = rank_correlations(points, column_of(points.numbers, a));
        for (std::size_t b = 0; b < a; ++b)
            if (with[b].rank_correlation && std::abs(with[b].rank_correlation->value) > most) return true;
    }
    return false;
}

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

/// Divides cells into batches that lie in one block each, of at most `most`.
std::vector<std::vector<std::size_t>> batches_of(const std::vector<std::size_t>& cells, const GridSpec& grid,
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
    for_each_hit_cell(members, quantity, grid, [&](std::size_t cell, Hits hits) {
        const auto exceeds = [&](const auto& hit) { return static_cast<double>(hit.value) > threshold; };
        const auto count = static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), exceeds));
        if (count > 0 && count < members.size()) rim.push_back(cell);
    });
    const CellWindow reached = reached_window(members, grid);
    const std::size_t at_once = std::max<std::size_t>(
        1, CellStore::k_budget_bytes / (sizeof(double) * std::max<std::size_t>(1, members.size())));
    for (const std::vector<std::size_t>& cells : batches_of(rim, grid, at_once)) {
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
