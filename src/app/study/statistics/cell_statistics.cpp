// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/cell_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>

#include "core/error.h"

namespace frana::app::study {
CellWindow window_of_both(const CellWindow& a, const CellWindow& b) {
    if (a.rows == 0 || b.rows == 0) return a.rows == 0 ? b : a;
    const std::int64_t row = std::min(a.row, b.row), column = std::min(a.column, b.column);
    return {row, column, std::max(a.row + a.rows, b.row + b.rows) - row,
            std::max(a.column + a.columns, b.column + b.columns) - column};
}

double effective_count(const std::vector<double>& weights) {
    double sum = 0, squares = 0;
    for (const double weight : weights) {
        sum += weight;
        squares += weight * weight;
    }
    return squares > 0 ? sum * sum / squares : 0;
}

CellWindow reached_window(const FinishedMembers& members, const GridSpec& grid) {
    CellWindow all;
    for (const RecordPlace& record : members.records) all = window_of_both(all, require_record(record).reached(grid));
    return all;
}

namespace {

/// Takes the hits of some of all, with their places among these.
class Chosen {
  public:
    /// @param of places of the chosen ones among all
    explicit Chosen(const std::vector<std::size_t>& of) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (places_.size() <= of[i]) places_.resize(of[i] + 1, k_none);
            places_[of[i]] = static_cast<std::uint32_t>(i);
        }
    }
    /// @returns what is valid until the next call
    const std::vector<CellStore::Value>& operator()(Hits all) {
        hits_.clear();
        for (const auto& [record, value] : all)
            if (record < places_.size() && places_[record] != k_none && !std::isnan(value))
                hits_.push_back({places_[record], value});
        return hits_;
    }

  private:
    static constexpr auto k_none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> places_;
    std::vector<CellStore::Value> hits_;
};

}  // namespace

void for_each_hit_cell(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                       const std::function<void(std::size_t cell, Hits hits)>& visit) {
    if (members.size() == 0) return;
    const auto store = members.store ? members.store : std::make_shared<CellStore>(members.records);
    std::vector<std::size_t> columns = members.columns;
    for (std::size_t m = columns.size(); m < members.size(); ++m) columns.push_back(m);
    Chosen chosen(columns);
    store->for_each_cell(quantity, grid, [&](std::size_t cell, Hits all) {
        if (const auto& hits = chosen(all); !hits.empty()) visit(cell, hits);
    });
}

void for_each_hit_cell(const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                       const std::function<void(std::size_t cell, Hits finished, Hits all)>& visit) {
    Chosen chosen(runs.finished_at);
    for_each_hit_cell(runs.all, quantity, grid, [&](std::size_t cell, Hits all) { visit(cell, chosen(all), all); });
}

double upper_bound(const StudyRuns& runs, std::span<const float> values, double threshold) {
    double sum = 0;
    for (std::size_t m = 0; m < values.size(); ++m)
        if (static_cast<double>(values[m]) > threshold || runs.is_open[m]) sum += runs.all.weights[m];
    return std::clamp(sum, 0.0, 1.0);
}

MeanEstimate::MeanEstimate(const FinishedMembers& members)
    : members_(members), effective_size_(members.effective_size()) {
    is_weighted_ = std::any_of(members.weights.begin(), members.weights.end(),
                               [&](double weight) { return weight != members.weights.front(); });
    if (members.size() > 0)
        greatest_weight_ = *std::max_element(members.weights.begin(), members.weights.end()) /
                           std::accumulate(members.weights.begin(), members.weights.end(), 0.0);
    for (const std::size_t part : std::set<std::size_t>(members.replicates.begin(), members.replicates.end())) {
        parts_.resize(part / k_replicates + 1);
        ++parts_.back();
    }
}

namespace {

constexpr double k_unknown_error = 0.5;  // of a probability, where one member or one replicate says nothing of others

}  // namespace

template <class ValueOf>
Estimate MeanEstimate::of(const ValueOf& value) const {
    const std::vector<double>& weights = members_.weights;
    Estimate estimate;
    double sum = 0, all = 0;
    for (std::size_t m = 0; m < weights.size(); ++m) {
        sum += weights[m] * value(m);
        all += weights[m];
    }
    estimate.value = sum / all;
    double squares = 0;
    if (parts_.empty()) {
        for (std::size_t m = 0; m < weights.size(); ++m)
            squares += weights[m] / all * (value(m) - estimate.value) * (value(m) - estimate.value);
        estimate.error = std::sqrt(squares / effective_size_);
        estimate.margin = k_normal * estimate.error;
    } else {
        std::array<double, std::size(k_round_ends) * k_replicates> differences{};
        for (std::size_t m = 0; m < weights.size(); ++m)
            differences[members_.replicates[m]] += weights[m] / all * (value(m) - estimate.value);
        const std::size_t fewest = *std::min_element(parts_.begin(), parts_.end());
        for (std::size_t round = 0; round < parts_.size() && fewest > 1; ++round) {
            const auto parts = static_cast<double>(parts_[round]);
            double of_round = 0, mean = 0;
            for (std::size_t part = round * k_replicates; part < (round + 1) * k_replicates; ++part) {
                of_round += differences[part] * differences[part];
                mean += differences[part] / parts;
            }
            squares += parts / (parts - 1) * std::max(0.0, of_round - parts * mean * mean);
        }
        estimate.error = fewest > 1 ? std::sqrt(squares) : std::numeric_limits<double>::infinity();
        estimate.margin = fewest > 1 ? k_student[fewest - 2] * estimate.error : estimate.error;
    }
    return estimate;
}

Estimate MeanEstimate::probability(std::span<const float> values, double threshold) const {
    const auto exceeds = [&](std::size_t m) { return static_cast<double>(values[m]) > threshold ? 1.0 : 0.0; };
    Estimate p = of(exceeds);
    const double nearer_half = (effective_size_ * p.value + 2) / (effective_size_ + 4);
    if (parts_.empty()) p.margin = k_normal * std::sqrt(nearer_half * (1 - nearer_half) / effective_size_);
    if (parts_.size() > 1) p.margin = k_student[k_replicates - 2] * std::sqrt(p.error * p.error + of_few(exceeds));
    if (parts_.size() == 1 && is_weighted_) p.margin = std::max(p.margin, of_alike(exceeds));
    if (!std::isfinite(p.error)) return {p.value, k_unknown_error, 1};
    constexpr double k_rounding = 1e-12;  // of sums of weights; no member has so little
    const bool is_alike = p.error < k_rounding;
    return {p.value, is_alike ? 0 : p.error, std::min(1.0, is_alike ? 3 * greatest_weight_ : p.margin)};
}

template <class Exceeds>
double MeanEstimate::of_few(const Exceeds& exceeds) const {
    std::array<double, 2> sums{}, squares{};
    for (std::size_t m = 0; m < members_.weights.size(); ++m) {
        const std::size_t kind = exceeds(m) > 0 ? 1 : 0;
        sums[kind] += members_.weights[m];
        squares[kind] += members_.weights[m] * members_.weights[m];
    }
    const std::size_t rarer = sums[1] < sums[0] ? 1 : 0;
    const double one = sums[rarer] > 0 ? squares[rarer] / sums[rarer] / (sums[0] + sums[1]) : 0;
    return 2 * one * one;
}

template <class Exceeds>
double MeanEstimate::of_alike(const Exceeds& exceeds) const {
    std::array<std::size_t, k_replicates> hits{};
    std::array<double, 2> sums{}, heaviest{};
    for (std::size_t m = 0; m < members_.weights.size(); ++m) {
        const std::size_t kind = exceeds(m) > 0 ? 1 : 0;
        hits[members_.replicates[m]] += kind;
        sums[kind] += members_.weights[m];
        heaviest[kind] = std::max(heaviest[kind], members_.weights[m]);
    }
    if (std::any_of(hits.begin(), hits.end(), [&](std::size_t count) { return count != hits.front(); })) return 0;
    return 3 * heaviest[sums[1] < sums[0] ? 1 : 0] / (sums[0] + sums[1]);
}

Estimate MeanEstimate::mean(std::span<const double> values) const {
    return of([&](std::size_t m) { return values[m]; });
}

Estimate MeanEstimate::mean(std::span<const double> values, double most) const {
    Estimate estimate = mean(values);
    if (!std::isfinite(estimate.error)) return {estimate.value, k_unknown_error * most, most};
    constexpr double k_rounding = 1e-12;
    if (estimate.error < k_rounding * most) return {estimate.value, 0, std::min(1.0, 3 * greatest_weight_) * most};
    estimate.margin = std::min(estimate.margin, most);
    return estimate;
}

namespace {

template <class Value>
double quantile_of(std::span<const Value> values, const std::vector<double>& weights, double q,
                   std::vector<std::size_t>& order) {
    order.resize(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
    double sum = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        sum += weights[order[i]];
        if (sum >= q - k_weight_rounding) return static_cast<double>(values[order[i]]);
    }
    return static_cast<double>(values[order.back()]);
}

}  // namespace

double weighted_quantile(std::span<const float> values, const std::vector<double>& weights, double q,
                         std::vector<std::size_t>& order) {
    return quantile_of(values, weights, q, order);
}

double weighted_quantile(const std::vector<double>& values, const std::vector<double>& weights, double q) {
    std::vector<std::size_t> order;
    return quantile_of(std::span<const double>(values), weights, q, order);
}

double correlation(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& weights) {
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0),
                 mean_x = std::inner_product(x.begin(), x.end(), weights.begin(), 0.0) / all,
                 mean_y = std::inner_product(y.begin(), y.end(), weights.begin(), 0.0) / all;
    double xx = 0, yy = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += weights[i] * (x[i] - mean_x) * (x[i] - mean_x);
        yy += weights[i] * (y[i] - mean_y) * (y[i] - mean_y);
        xy += weights[i] * (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (!(xx > 0) || !(yy > 0)) return std::numeric_limits<double>::quiet_NaN();
    return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

void for_each_feature(const StudyRuns& runs, Quantity quantity, const GridSpec& grid,
                      const std::vector<std::vector<std::size_t>>& cells, const RunValues& visit) {
    const std::size_t count = runs.all.size(),
                      at_once = std::max<std::size_t>(
                          1, CellStore::k_budget_bytes / sizeof(float) / std::max<std::size_t>(1, count));
    const bool is_arrival = quantity == Quantity::arrival;
    for (std::size_t first = 0; first < cells.size() && count > 0; first += at_once) {
        const std::size_t last = std::min(first + at_once, cells.size());
        std::multimap<std::size_t, std::size_t> features;  // by cell
        for (std::size_t feature = first; feature < last; ++feature)
            for (const std::size_t cell : cells[feature]) features.emplace(cell, feature - first);
        std::vector<float> all((last - first) * count, nothing_of(quantity)), finished(runs.finished.size());
        for_each_hit_cell(runs.all, quantity, grid, [&](std::size_t cell, Hits hits) {
            const auto [begin, end] = features.equal_range(cell);
            for (auto one = begin; one != end; ++one)
                for (const auto& [run, hit] : hits) {
                    float& value = all[one->second * count + run];
                    value = is_arrival ? std::min(value, hit) : std::max(value, hit);
                }
        });
        for (std::size_t feature = first; feature < last; ++feature) {
            const std::span<const float> of_all(all.data() + (feature - first) * count, count);
            for (std::size_t m = 0; m < finished.size(); ++m) finished[m] = of_all[runs.finished_at[m]];
            visit(feature, finished, of_all);
        }
    }
}

}  // namespace frana::app::study
