// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/annual_rates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frana::app::study {
namespace {

double square(double value) {
    return value * value;
}

double squares_of(const FrequencySpec::Rate& rate, double margin) {
    return square(rate.value * margin) + square(rate.deviation * margin);
}

/// The greatest value that is reached at a rate, by those that stand for the greater ones too.
double value_exceeded(std::vector<CellStore::Value> hits, const std::vector<double>& rates, double so_far,
                      double rate) {
    std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) {
        return a.value != b.value ? a.value > b.value : a.record < b.record;
    });
    const double enough = rate * (1 - k_weight_rounding);
    for (const auto& [member, value] : hits)
        if ((so_far += rates[member]) >= enough) return std::max(0.0, static_cast<double>(value));
    return 0;
}

}  // namespace

AnnualRates::AnnualRates(std::vector<Source> sources, bool is_common_rate, std::vector<bool> is_open)
    : sources_(std::move(sources)), is_open_(std::move(is_open)), is_common_rate_(is_common_rate) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        const Source& source = sources_[i];
        const MeanEstimate& estimate = estimates_.emplace_back(source.members);
        for (const double weight : source.members.weights) {
            source_of_.push_back(i);
            member_rates_.push_back(source.rate.value * weight);
        }
        for (const double share : source.shares) {
            open_rate_ += is_open_[run_rates_.size()] ? source.rate.value * share : 0;
            run_rates_.push_back(source.rate.value * share);
        }
        if (source.members.size() == 0) continue;
        const std::vector<float> nothing(source.members.size());
        nowhere_ = std::max(nowhere_, std::sqrt(squares_of(source.rate, estimate.probability(nothing, 0).margin)));
    }
}

FrequencySpec::Rate AnnualRates::of_all() const {
    FrequencySpec::Rate all;
    double sum = 0, squares = 0;
    for (const Source& source : sources_) {
        all.value += source.rate.value;
        sum += source.rate.deviation;
        squares += square(source.rate.deviation);
    }
    all.deviation = is_common_rate_ ? sum : std::sqrt(squares);
    return all;
}

template <class Visit>
void AnnualRates::for_each_source(Hits hits, double threshold, const Visit& visit) const {
    std::vector<float> values;
    for (std::size_t begin = 0, end = 0; begin < hits.size(); begin = end) {
        const std::size_t source = source_of_[hits[begin].record];
        values.assign(sources_[source].members.size(), 0);
        const Source& own = sources_[source];
        double change = 0;
        for (; end < hits.size() && source_of_[hits[end].record] == source; ++end) {
            const std::size_t member = hits[end].record - own.first;
            values[member] = hits[end].value;
            if (!own.sway.empty() && static_cast<double>(hits[end].value) > threshold) change += own.sway[member];
        }
        visit(source, estimates_[source].probability(values, threshold), change);
    }
}

template <class Each>
AnnualRate AnnualRates::sum_of(const Each& each) const {
    double value = 0, squares = 0, of_rates = 0, of_laws = 0, each_squared = 0;
    each([&](std::size_t source, const Estimate& estimate, double change) {
        const FrequencySpec::Rate& rate = sources_[source].rate;
        const double by_rate = k_normal * rate.deviation * estimate.value, by_law = k_normal * rate.value * change;
        value += rate.value * estimate.value;
        squares += squares_of(rate, estimate.margin);
        of_rates += by_rate;
        of_laws += by_law;
        each_squared += square(by_rate) + square(by_law);
    });
    return {value, std::sqrt(squares + (is_common_rate_ ? square(of_rates) + square(of_laws) : each_squared))};
}

AnnualRate AnnualRates::exceeded(Hits hits, double threshold) const {
    if (hits.empty()) return {0, nowhere_};
    return sum_of([&](const auto& visit) { for_each_source(hits, threshold, visit); });
}

AnnualRate AnnualRates::sum(std::span<const double> values, double most) const {
    const auto is_hit = [](double value) { return value > 0; };
    if (std::none_of(values.begin(), values.end(), is_hit)) return {0, nowhere_ * most};
    return sum_of([&](const auto& visit) {
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            const auto own = values.subspan(sources_[i].first, sources_[i].members.size());
            if (std::none_of(own.begin(), own.end(), is_hit)) continue;
            double change = 0;
            for (std::size_t member = 0; member < sources_[i].sway.size(); ++member)
                change += sources_[i].sway[member] * own[member];
            visit(i, estimates_[i].mean(own, most), change);
        }
    });
}

double AnnualRates::bound_of_sum(std::span<const double> runs, double most) const {
    double sum = open_rate_ * most;
    for (std::size_t run = 0; run < runs.size(); ++run)
        if (!is_open_[run]) sum += run_rates_[run] * runs[run];
    return sum;
}

std::vector<double> AnnualRates::by_source(Hits hits, double threshold) const {
    std::vector<double> all(sources_.size());
    for_each_source(hits, threshold, [&](std::size_t source, const Estimate& probability, double) {
        all[source] = sources_[source].rate.value * probability.value;
    });
    return all;
}

double AnnualRates::bound(Hits runs, double threshold) const {
    double rate = open_rate_;
    for (const auto& [run, value] : runs)
        if (!is_open_[run] && static_cast<double>(value) > threshold) rate += run_rates_[run];
    return rate;
}

double AnnualRates::value_at(Hits hits, double rate) const {
    return value_exceeded({hits.begin(), hits.end()}, member_rates_, 0, rate);
}

double AnnualRates::bound_at(Hits runs, double rate) const {
    if (open_rate_ >= rate * (1 - k_weight_rounding)) return std::numeric_limits<double>::infinity();
    std::vector<CellStore::Value> ended(runs.begin(), runs.end());
    std::erase_if(ended, [&](const auto& hit) { return is_open_[hit.record]; });
    return value_exceeded(std::move(ended), run_rates_, open_rate_, rate);
}

RateMaps rate_maps(const AnnualRates& rates, const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                   const std::vector<double>& thresholds, const std::vector<double>& periods) {
    RateMaps maps;
    maps.rate.assign(thresholds.size(), Raster(grid));
    maps.margin.assign(thresholds.size(), Raster(grid, rates.exceeded({}, 0).margin));
    if (rates.has_open()) maps.upper.assign(thresholds.size(), Raster(grid, rates.bound({}, 0)));
    const Raster nothing(grid, k_no_data);
    maps.once.assign(periods.size(), {nothing, nothing, nothing});
    for_each_hit_cell(runs, quantity, grid, [&](std::size_t cell, Hits hits, Hits all) {
        for (std::size_t t = 0; t < thresholds.size(); ++t) {
            const AnnualRate rate = rates.exceeded(hits, thresholds[t]);
            maps.rate[t].values[cell] = rate.value;
            maps.margin[t].values[cell] = rate.margin;
            if (rates.has_open()) maps.upper[t].values[cell] = std::max(rate.value, rates.bound(all, thresholds[t]));
        }
        for (std::size_t i = 0; i < periods.size() && !hits.empty(); ++i) {
            const double once = 1 / periods[i], value = rates.value_at(hits, once),
                         margin = rates.exceeded(hits, value).margin, bound = rates.bound_at(all, once);
            double& high = maps.once[i].high.values[cell];
            maps.once[i].value.values[cell] = value;
            maps.once[i].low.values[cell] = rates.value_at(hits, once + margin);
            high = once > margin ? rates.value_at(hits, once - margin) : k_no_data;
            if (rates.has_open()) high = std::isnan(high) || std::isinf(bound) ? k_no_data : std::max(high, bound);
        }
    });
    return maps;
}

}  // namespace frana::app::study
