// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/study_maps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/study/member_record.h"
#include "core/error.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {

namespace {

/// The greatest value in each cell; `value_of` a hit returns NaN if it has none.
template <class ValueOf>
Raster worst_of(const FinishedMembers& members, Quantity quantity, const GridSpec& grid, const ValueOf& value_of) {
    Raster worst(grid, k_no_data);
    for_each_hit_cell(members, quantity, grid, [&](std::size_t cell, Hits hits) {
        double greatest = k_no_data;
        for (const CellStore::Value& hit : hits) greatest = std::fmax(greatest, value_of(hit));
        if (!std::isnan(greatest)) worst.values[cell] = greatest;
    });
    return worst;
}

}  // namespace

DepthUnion depth_union(const FinishedMembers& members, const GridSpec& grid) {
    DepthUnion maps{Raster(grid, k_no_data), Raster(grid, k_no_data), Raster(grid, k_no_data)};
    for_each_hit_cell(members, Quantity::depth, grid, [&](std::size_t cell, Hits hits) {
        const auto deepest =
            std::max_element(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
        maps.depth.values[cell] = static_cast<double>(deepest->value);
        maps.worst.values[cell] = static_cast<double>(members.columns[deepest->record]);
        maps.hits.values[cell] = static_cast<double>(
            std::count_if(hits.begin(), hits.end(), [](const CellStore::Value& hit) { return hit.value > 0; }));
    });
    return maps;
}

Raster greatest_of(const FinishedMembers& members, Quantity quantity, const GridSpec& grid) {
    return worst_of(members, quantity, grid, [&](const CellStore::Value& hit) {
        return quantity == Quantity::intensity && !(hit.value > 0) ? k_no_data : static_cast<double>(hit.value);
    });
}

Raster earliest_arrival(const FinishedMembers& members, const GridSpec& grid) {
    Raster earliest = worst_of(members, Quantity::arrival, grid, [](const CellStore::Value& hit) {
        return std::isfinite(hit.value) ? -static_cast<double>(hit.value) : k_no_data;
    });
    earliest.values.for_each_stored([&](std::size_t cell, double value) { earliest.values[cell] = -value; });
    return earliest;
}

Raster worst_degree(const FinishedMembers& members, const std::vector<std::optional<double>>& periods,
                    const GridSpec& grid, const DegreeMatrix& degrees) {
    return worst_of(members, Quantity::intensity, grid, [&](const CellStore::Value& hit) {
        const auto& period = periods[hit.record];
        return hit.value >= 1 && period ? static_cast<double>(degrees.of(static_cast<int>(hit.value), *period))
                                        : k_no_data;
    });
}

namespace {

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

QuantityMaps quantity_maps(const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                           const std::vector<double>& thresholds) {
    QuantityMaps maps;
    const bool arrival = quantity == Quantity::arrival, has_open = !arrival && runs.any_open(),
               has_distribution = quantity == Quantity::depth || quantity == Quantity::velocity;
    const FinishedMembers& members = runs.finished;
    const MeanEstimate estimate(members);
    if (!arrival) {
        maps.probability.assign(thresholds.size(), Raster(grid));
        const std::vector<float> nowhere(members.size()), of_all(runs.all.size());
        const double margin = members.size() > 0 ? estimate.probability(nowhere, 0).margin : 1;
        maps.margin.assign(thresholds.size(), Raster(grid, margin));
        for (std::size_t t = 0; t < thresholds.size() && has_open; ++t)
            maps.upper.emplace_back(grid, upper_bound(runs, of_all, thresholds[t]));
    }
    if (has_distribution) maps.hits = Raster(grid, k_no_data);
    if (has_distribution || arrival) maps.quantile.assign(std::size(k_study_quantiles), Raster(grid, k_no_data));
    double open = 0;
    for (std::size_t m = 0; m < runs.is_open.size(); ++m) open += runs.is_open[m] ? runs.all.weights[m] : 0;
    for (std::size_t q = 0; q < std::size(k_study_quantiles) && has_distribution && has_open; ++q)
        maps.quantile_upper.push_back(open > 1 - k_study_quantiles[q].fraction + k_weight_rounding
                                          ? std::nullopt
                                          : std::optional(Raster(grid, k_no_data)));
    std::vector<std::size_t> order;
    const auto add_bounds = [&](std::size_t cell, std::span<const float> all) {
        for (std::size_t t = 0; t < maps.upper.size(); ++t)
            maps.upper[t].values[cell] =
                std::max(std::as_const(maps.probability[t]).values[cell], upper_bound(runs, all, thresholds[t]));
        const std::vector<float> extreme = runs.at_most(all);
        for (std::size_t q = 0; q < maps.quantile_upper.size(); ++q)
            if (auto& bound = maps.quantile_upper[q])
                if (const double value = quantile_at(extreme, runs.all.weights, q, order); !std::isnan(value))
                    bound->values[cell] = value;
    };
    const auto add_finished = [&](std::size_t cell, std::span<const float> values) {
        if (arrival) {
            double arrived = 0;
            for (std::size_t m = 0; m < values.size(); ++m)
                arrived += std::isfinite(values[m]) ? members.weights[m] : 0;
            for (std::size_t q = 0; q < maps.quantile.size() && arrived > 0; ++q)
                maps.quantile[q].values[cell] =
                    weighted_quantile(values, members.weights, k_study_quantiles[q].fraction * arrived, order);
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
    };
    std::vector<float> finished(members.size(), nothing_of(quantity)), every(runs.all.size(), nothing_of(quantity));
    for_each_hit_cell(runs, quantity, grid, [&](std::size_t cell, Hits of_finished, Hits of_all) {
        for (const CellStore::Value& hit : of_finished) finished[hit.record] = hit.value;
        for (const CellStore::Value& hit : of_all) every[hit.record] = hit.value;
        if (!of_finished.empty()) add_finished(cell, finished);
        if (has_open) add_bounds(cell, every);
        for (const CellStore::Value& hit : of_finished) finished[hit.record] = nothing_of(quantity);
        for (const CellStore::Value& hit : of_all) every[hit.record] = nothing_of(quantity);
    });
    return maps;
}

}  // namespace frana::app::study
