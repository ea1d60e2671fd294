// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/study_maps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

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

/// The greatest value in each cell; `value_of` returns NaN where a member has none.
template <class ValueOf>
Raster worst_of(const std::vector<UnionMember>& members, const GridSpec& grid, const ValueOf& value_of) {
    Raster worst(grid, k_no_data);
    for_each_cell(members, grid,
                  [&](const UnionMember& member, const MemberRecord& record, std::size_t cell, std::size_t index) {
                      const double value = value_of(member, record, index);
                      if (!std::isnan(value)) worst.values[cell] = std::fmax(worst.values[cell], value);
                  });
    return worst;
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
    return worst_of(members, grid, [&](const UnionMember&, const MemberRecord& record, std::size_t index) {
        const std::vector<float>& values = record.of(quantity);
        const double value = values.empty() ? k_no_data : static_cast<double>(values[index]);
        return quantity == Quantity::intensity && !(value > 0) ? k_no_data : value;
    });
}

Raster earliest_arrival(const std::vector<UnionMember>& members, const GridSpec& grid) {
    Raster earliest = worst_of(members, grid, [](const UnionMember&, const MemberRecord& record, std::size_t index) {
        const auto arrival = static_cast<double>(record.arrival[index]);
        return std::isfinite(arrival) ? -arrival : k_no_data;
    });
    earliest.values.for_each_stored([&](std::size_t cell, double value) { earliest.values[cell] = -value; });
    return earliest;
}

Raster worst_degree(const std::vector<UnionMember>& members, const GridSpec& grid, const DegreeMatrix& degrees) {
    return worst_of(members, grid, [&](const UnionMember& member, const MemberRecord& record, std::size_t index) {
        if (record.intensity.empty() || !(record.intensity[index] >= 1) || !member.return_period) return k_no_data;
        return static_cast<double>(degrees.of(static_cast<int>(record.intensity[index]), *member.return_period));
    });
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
    for (double& weight : arrived.weights) weight /= sum;
    return arrived;
}

/// Returns the value of quantile q of a cell; NaN where that is 0.
double quantile_at(std::span<const float> values, const std::vector<double>& weights, std::size_t q,
                   std::vector<std::size_t>& order) {
    const double value = weighted_quantile(values, weights, k_study_quantiles[q].fraction, order);
    return value > 0 ? value : k_no_data;
}

}  // namespace

void ErrorSummary::add(const Estimate& probability) {
    if (!(probability.error > 0)) return;
    const auto most = static_cast<double>(classes_.size()) - 1;
    Class& one = classes_[static_cast<std::size_t>(std::clamp((most + 1) * probability.value, 0.0, most))];
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
    if (has_distribution) maps.hits = Raster(grid, k_no_data);
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
        for (std::size_t q = 0; q < maps.quantile.size(); ++q)
            if (const double value = quantile_at(values, members.weights, q, order); !std::isnan(value))
                maps.quantile[q].values[cell] = value;
        maps.hits.values[cell] =
            static_cast<double>(std::count_if(values.begin(), values.end(), [](float v) { return v > 0; }));
    });
    return maps;
}

std::vector<Raster> probability_bounds(const std::vector<Raster>& probability, const OpenRuns& runs, Quantity quantity,
                                       const std::vector<double>& thresholds, const GridSpec& grid) {
    const std::vector<float> nothing(runs.is_open.size(), 0.0F);
    std::vector<Raster> bounds;
    for (const double threshold : thresholds) bounds.emplace_back(grid, upper_bound(runs, nothing, threshold));
    for_each_reached_cell(runs.runs, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        for (std::size_t t = 0; t < thresholds.size(); ++t)
            bounds[t].values[cell] = std::max(probability[t].values[cell], upper_bound(runs, values, thresholds[t]));
    });
    return bounds;
}

std::vector<std::optional<Raster>> quantile_bounds(const OpenRuns& runs, Quantity quantity, const GridSpec& grid) {
    double open = 0;
    for (std::size_t m = 0; m < runs.is_open.size(); ++m) open += runs.is_open[m] ? runs.runs.weights[m] : 0;
    std::vector<std::optional<Raster>> bounds;
    for (const StudyQuantile& quantile : k_study_quantiles)
        bounds.push_back(open > 1 - quantile.fraction + k_weight_rounding ? std::nullopt
                                                                          : std::optional(Raster(grid, k_no_data)));
    std::vector<std::size_t> order;
    std::vector<float> extreme;
    for_each_reached_cell(runs.runs, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        extreme.assign(values.begin(), values.end());
        for (std::size_t m = 0; m < extreme.size(); ++m)
            if (runs.is_open[m]) extreme[m] = std::numeric_limits<float>::infinity();
        for (std::size_t q = 0; q < bounds.size(); ++q) {
            if (!bounds[q]) continue;
            const double value = quantile_at(extreme, runs.runs.weights, q, order);
            if (!std::isnan(value)) bounds[q]->values[cell] = value;
        }
    });
    return bounds;
}

ErrorSummary error_of(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                      const std::vector<double>& thresholds) {
    const MeanEstimate estimate(members);
    ErrorSummary all;
    for_each_reached_cell(members, quantity, grid, [&](std::size_t, std::span<const float> values) {
        for (const double threshold : thresholds) all.add(estimate.probability(values, threshold));
    });
    return all;
}

}  // namespace frana::app::study
