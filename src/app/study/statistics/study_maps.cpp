// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/study_maps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/trace.h"
#include "app/study/member_record.h"
#include "core/error.h"
#include "core/text.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana::app::study {

namespace {

/// Calls visit(member, record, cell, index) for the cells that each member reached.
template <class Visit>
void for_each_cell(const std::vector<UnionMember>& members, const GridSpec& grid, const Visit& visit) {
    for (const UnionMember& member : members) {
        const MemberRecord record = require_record(member.record);
        record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
            if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
            visit(member, record, static_cast<std::size_t>(row * grid.columns + column), index);
        });
    }
}

void raise(double& greatest, double value) {
    greatest = std::isnan(greatest) ? value : std::max(greatest, value);
}

}  // namespace

DepthUnion depth_union(const std::vector<UnionMember>& members, const GridSpec& grid) {
    DepthUnion maps{Raster(grid, k_no_data), Raster(grid, k_no_data), Raster(grid, k_no_data)};
    for_each_cell(members, grid,
                  [&](const UnionMember& member, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const auto depth = static_cast<double>(record.depth[index]);
                      double& deepest = maps.depth.values[cell];
                      if (std::isnan(deepest) || depth > deepest) {
                          deepest = depth;
                          maps.worst.values[cell] = static_cast<double>(member.number);
                      }
                      double& hits = maps.hits.values[cell];
                      hits = (std::isnan(hits) ? 0 : hits) + (depth > 0 ? 1 : 0);
                  });
    return maps;
}

Raster greatest_of(const std::vector<UnionMember>& members, Quantity quantity, const GridSpec& grid) {
    Raster greatest(grid, k_no_data);
    for_each_cell(members, grid,
                  [&](const UnionMember&, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const std::vector<float>& values = record.of(quantity);
                      const bool has_class = quantity != Quantity::intensity || (!values.empty() && values[index] > 0);
                      if (!values.empty() && has_class)
                          raise(greatest.values[cell], static_cast<double>(values[index]));
                  });
    return greatest;
}

Raster earliest_arrival(const std::vector<UnionMember>& members, const GridSpec& grid) {
    Raster earliest(grid, k_no_data);
    for_each_cell(members, grid,
                  [&](const UnionMember&, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const auto arrival = static_cast<double>(record.arrival[index]);
                      if (!std::isfinite(arrival)) return;
                      double& first = earliest.values[cell];
                      first = std::isnan(first) ? arrival : std::min(first, arrival);
                  });
    return earliest;
}

Raster worst_degree(const std::vector<UnionMember>& members, const GridSpec& grid, const DegreeMatrix& degrees) {
    Raster worst(grid, k_no_data);
    for_each_cell(
        members, grid, [&](const UnionMember& member, const MemberRecord& record, std::size_t cell, std::size_t index) {
            if (record.intensity.empty() || !(record.intensity[index] >= 1) || !member.return_period) return;
            raise(worst.values[cell],
                  static_cast<double>(degrees.of(static_cast<int>(record.intensity[index]), *member.return_period)));
        });
    return worst;
}

namespace {

/// Values of the members that came to a cell, and their weights with a sum of 1.
struct Arrived {
    std::vector<float> values;
    std::vector<double> weights;
};

Arrived arrived_of(std::span<const float> values, const std::vector<double>& weights) {
    Arrived arrived;
    double sum = 0;
    for (std::size_t m = 0; m < values.size(); ++m) {
        if (!std::isfinite(values[m])) continue;
        arrived.values.push_back(values[m]);
        arrived.weights.push_back(weights[m]);
        sum += weights[m];
    }
    if (!(sum > 0)) return {};  // only in a multilevel study: it is estimated that no run comes
    for (double& weight : arrived.weights) weight /= sum;
    return arrived;
}

void add_moments(std::span<const float> values, const std::vector<double>& weights, std::size_t cell,
                 QuantityMaps& maps) {
    double mean = 0, squares = 0, hits = 0;
    for (std::size_t m = 0; m < values.size(); ++m) {
        mean += weights[m] * static_cast<double>(values[m]);
        hits += values[m] > 0 ? 1 : 0;
    }
    for (std::size_t m = 0; m < values.size(); ++m) {
        const double difference = static_cast<double>(values[m]) - mean;
        squares += weights[m] * difference * difference;
    }
    // Below 0 only by estimate, with levels.
    maps.mean.values[cell] = std::max(0.0, mean);
    maps.deviation.values[cell] = std::sqrt(std::max(0.0, squares));
    maps.hits.values[cell] = hits;
}

/// Of the distances of cells from the outlines of all members: each lot of cells reads every record again.
constexpr std::size_t k_distance_bytes = 256'000'000;
/// Distances are computed block by block with so many cells around it: the ground between flows far apart costs
/// nothing.
constexpr std::int64_t k_block = 1024, k_far = 512;

}  // namespace

void ErrorSummary::add(const Estimate& probability) {
    if (!(probability.error > 0)) return;
    const auto at = static_cast<std::size_t>(static_cast<double>(classes_.size()) * probability.value);
    Class& one = classes_[std::min(at, classes_.size() - 1)];
    one.count += 1;
    one.sum += probability.error;
    one.squares += probability.error * probability.error;
}

void ErrorSummary::add(const ErrorSummary& other) {
    for (std::size_t i = 0; i < classes_.size(); ++i) {
        classes_[i].count += other.classes_[i].count;
        classes_[i].sum += other.classes_[i].sum;
        classes_[i].squares += other.classes_[i].squares;
    }
}

double ErrorSummary::largest() const {
    double square = 0;
    for (const Class& one : classes_)
        if (one.count > 0) square = std::max(square, one.squares / one.count);
    return std::sqrt(square);
}

double ErrorSummary::mean() const {
    double sum = 0, count = 0;
    for (const Class& one : classes_) {
        sum += one.sum;
        count += one.count;
    }
    return count > 0 ? sum / count : 0;
}

QuantityMaps quantity_maps(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                           const std::vector<double>& thresholds) {
    QuantityMaps maps;
    const bool arrival = quantity == Quantity::arrival,
               has_distribution = quantity == Quantity::depth || quantity == Quantity::velocity;
    const MeanEstimate estimate(members);
    if (!arrival) {
        maps.probability.assign(thresholds.size(), Raster(grid));
        const std::vector<float> nowhere(members.size());
        const double margin = members.size() > 0 ? estimate.probability(nowhere, 0).margin : 1;
        maps.margin.assign(thresholds.size(), Raster(grid, margin));
    }
    if (has_distribution) maps.mean = maps.deviation = maps.hits = Raster(grid, k_no_data);
    if (has_distribution || arrival) maps.quantile.assign(std::size(k_study_quantiles), Raster(grid, k_no_data));
    if (members.size() == 0) return maps;
    std::vector<std::size_t> order;
    for_each_reached_cell(members, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        if (arrival) {
            const Arrived arrived = arrived_of(values, members.weights);
            for (std::size_t q = 0; q < std::size(k_study_quantiles) && !arrived.values.empty(); ++q)
                maps.quantile[q].values[cell] =
                    weighted_quantile(arrived.values, arrived.weights, k_study_quantiles[q].fraction, order);
            return;
        }
        for (std::size_t t = 0; t < thresholds.size(); ++t) {
            const Estimate probability = estimate.probability(values, thresholds[t]);
            maps.probability[t].values[cell] = probability.value;
            maps.margin[t].values[cell] = probability.margin;
            maps.errors.add(probability);
        }
        if (!has_distribution) return;
        for (std::size_t q = 0; q < std::size(k_study_quantiles); ++q) {
            const double value = weighted_quantile(values, members.weights, k_study_quantiles[q].fraction, order);
            if (value > 0) maps.quantile[q].values[cell] = value;
        }
        add_moments(values, members.weights, cell, maps);
    });
    return maps;
}

std::vector<RasterInterval> probability_bounds(const std::vector<Raster>& probability, const OpenRuns& runs,
                                               Quantity quantity, const std::vector<double>& thresholds,
                                               const GridSpec& grid) {
    const std::vector<float> nothing(runs.is_open.size(), 0.0F);
    std::vector<RasterInterval> bounds;
    for (const double threshold : thresholds)
        bounds.push_back({Raster(grid, sum_bound(runs, nothing, threshold, false)),
                          Raster(grid, sum_bound(runs, nothing, threshold, true))});
    for_each_reached_cell(runs.runs, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        for (std::size_t t = 0; t < thresholds.size(); ++t) {
            const double p = probability[t].values[cell];
            bounds[t].lower.values[cell] = std::min(p, sum_bound(runs, values, thresholds[t], false));
            bounds[t].upper.values[cell] = std::max(p, sum_bound(runs, values, thresholds[t], true));
        }
    });
    return bounds;
}

std::vector<std::optional<Raster>> quantile_bounds(const OpenRuns& runs, bool upper, Quantity quantity,
                                                   const GridSpec& grid) {
    double open = 0;
    for (std::size_t m = 0; m < runs.is_open.size(); ++m) open += runs.exceeds(m, true) ? runs.runs.weights[m] : 0;
    std::vector<std::optional<Raster>> bounds;
    for (const StudyQuantile& quantile : k_study_quantiles)
        bounds.push_back(upper && open > 1 - quantile.fraction + k_weight_rounding
                             ? std::nullopt
                             : std::optional(Raster(grid, k_no_data)));
    std::vector<std::size_t> order;
    std::vector<float> extreme;
    for_each_reached_cell(runs.runs, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        extreme.assign(values.begin(), values.end());
        for (std::size_t m = 0; m < extreme.size(); ++m)
            if (runs.exceeds(m, upper)) extreme[m] = std::numeric_limits<float>::infinity();
        for (std::size_t q = 0; q < bounds.size(); ++q) {
            if (!bounds[q]) continue;
            const double value = weighted_quantile(extreme, runs.runs.weights, k_study_quantiles[q].fraction, order);
            if (value > 0) bounds[q]->values[cell] = value;
        }
    });
    return bounds;
}

ErrorSummary error_of_first(const FinishedMembers& members, std::size_t count, Quantity quantity, const GridSpec& grid,
                            const std::vector<double>& thresholds) {
    FinishedMembers first = members;
    first.records.resize(count);
    first.weights.resize(count);
    if (!first.replicates.empty()) first.replicates.resize(count);
    if (!first.levels.empty()) first.levels.resize(count);
    const MeanEstimate estimate(first);
    ErrorSummary all;
    for_each_reached_cell(first, quantity, grid, [&](std::size_t, std::span<const float> values) {
        for (const double threshold : thresholds) all.add(estimate.probability(values, threshold));
    });
    return all;
}

namespace {

/// Signed distances of some cells of a grid from a member's outline, in cells; up to k_far they are exact.
/// @param window of the cells and k_far around them, as far as any member comes
std::vector<double> distances_from_outline(const MemberRecord& record, const GridSpec& grid, const CellWindow& window,
                                           double threshold, const std::vector<std::size_t>& cells) {
    const auto columns = static_cast<std::size_t>(window.columns + 2);  // with a border where nothing comes
    std::vector<char> inside(columns * static_cast<std::size_t>(window.rows + 2));
    const auto place = [&](std::int64_t row, std::int64_t column) {
        return static_cast<std::size_t>(row - window.row + 1) * columns +
               static_cast<std::size_t>(column - window.column + 1);
    };
    record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
        if (row < window.row || column < window.column || row >= window.row + window.rows ||
            column >= window.column + window.columns)
            return;
        inside[place(row, column)] = static_cast<double>(record.depth[index]) > threshold ? 1 : 0;
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

std::vector<Raster> sensitivity_maps(const FinishedMembers& members, const DesignPoints& points, const GridSpec& grid,
                                     double threshold) {
    std::vector<Raster> maps(points.nominal.size(), Raster(grid, k_no_data));
    std::vector<std::size_t> rim;  // cells that some members reach and others do not
    for_each_reached_cell(members, Quantity::depth, grid, [&](std::size_t cell, std::span<const float> values) {
        const auto exceeds = [&](float value) { return static_cast<double>(value) > threshold; };
        const auto count = static_cast<std::size_t>(std::count_if(values.begin(), values.end(), exceeds));
        if (count > 0 && count < values.size()) rim.push_back(cell);
    });
    const CellWindow reached = reached_window(members, grid);
    const std::size_t at_once = std::max<std::size_t>(1, k_distance_bytes / (sizeof(double) * members.size()));
    for (const std::vector<std::size_t>& cells : lots_of(rim, grid, at_once)) {
        const CellWindow window = window_around(cells, grid, reached);
        std::vector<std::vector<double>> outputs(cells.size());
        for (const std::string& file : members.records) {
            const std::vector<double> distances =
                distances_from_outline(require_record(file), grid, window, threshold, cells);
            for (std::size_t i = 0; i < cells.size(); ++i) outputs[i].push_back(distances[i]);
        }
        const std::vector<Chaos> all = openturns().chaos(points, outputs);
        for (std::size_t i = 0; i < cells.size(); ++i)
            for (std::size_t k = 0; k < maps.size() && all[i].q2 >= k_least_q2; ++k)
                maps[k].values[cells[i]] = all[i].first_order[k];
    }
    return maps;
}

}  // namespace frana::app::study
