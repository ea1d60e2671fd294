// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/cell_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "core/error.h"

namespace frana::app::study {
namespace {

constexpr std::size_t k_budget_bytes = 256'000'000;

CellWindow inside(const CellWindow& window, const GridSpec& grid) {
    const std::int64_t top = std::max<std::int64_t>(0, window.row), left = std::max<std::int64_t>(0, window.column);
    return {top, left, std::min(window.row + window.rows, grid.rows) - top,
            std::min(window.column + window.columns, grid.columns) - left};
}

}  // namespace

MemberRecord require_record(const std::string& path) {
    auto record = read_record(path);
    if (!record)
        throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", path, "", "",
                                                    "Check the disk; --resume computes that member again"});
    return *std::move(record);
}

double FinishedMembers::effective_size() const {
    double sum = 0, squares = 0;
    for (const double weight : weights) {
        sum += weight;
        squares += weight * weight;
    }
    return squares > 0 ? sum * sum / squares : 0;
}

CellWindow reached_window(const FinishedMembers& members, const GridSpec& grid) {
    constexpr std::int64_t k_far = std::numeric_limits<std::int64_t>::max();
    std::int64_t top = k_far, bottom = -k_far, left = k_far, right = -k_far;
    for (const std::string& file : members.records) {
        require_record(file).for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t) {
            top = std::min(top, row);
            bottom = std::max(bottom, row);
            left = std::min(left, column);
            right = std::max(right, column);
        });
    }
    if (bottom < top) return {};
    return {top, left, bottom - top + 1, right - left + 1};
}

void for_each_reached_cell(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                           const std::function<void(std::size_t cell, std::span<const float> values)>& visit) {
    const CellWindow window = inside(reached_window(members, grid), grid);
    if (window.rows <= 0 || window.columns <= 0) return;
    const std::size_t count = members.size(), columns = static_cast<std::size_t>(window.columns);
    const auto rows_at_once =
        static_cast<std::int64_t>(std::max<std::size_t>(1, k_budget_bytes / (sizeof(float) * count * columns)));
    const float nothing = quantity == Quantity::arrival ? std::numeric_limits<float>::infinity() : 0.0F;
    for (std::int64_t first = window.row; first < window.row + window.rows; first += rows_at_once) {
        const std::int64_t last = std::min(first + rows_at_once, window.row + window.rows);
        const std::size_t cells = static_cast<std::size_t>(last - first) * columns;
        std::vector<float> values(cells * count, nothing);
        std::vector<bool> reached(cells);
        for (std::size_t m = 0; m < count; ++m) {
            const MemberRecord record = require_record(members.records[m]);
            const std::vector<float>& of_member = record.of(quantity);
            record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
                const bool is_inside =
                    row >= first && row < last && column >= window.column && column < window.column + window.columns;
                if (!is_inside) return;
                const std::size_t cell =
                    static_cast<std::size_t>(row - first) * columns + static_cast<std::size_t>(column - window.column);
                reached[cell] = true;
                values[cell * count + m] = of_member[index];
            });
        }
        for (std::size_t cell = 0; cell < cells; ++cell) {
            if (!reached[cell]) continue;
            const auto row = first + static_cast<std::int64_t>(cell / columns),
                       column = window.column + static_cast<std::int64_t>(cell % columns);
            visit(static_cast<std::size_t>(row * grid.columns + column), {values.data() + cell * count, count});
        }
    }
}

double sum_bound(const OpenRuns& runs, std::span<const float> values, double threshold, bool upper) {
    double sum = 0;
    for (std::size_t m = 0; m < values.size(); ++m)
        if (static_cast<double>(values[m]) > threshold || runs.exceeds(m, upper)) sum += runs.runs.weights[m];
    return std::clamp(sum, 0.0, 1.0);
}

namespace {

/// The differences between the two indicators (0 or 1) of an event in each pair of runs of a level.
struct LevelDifference {
    double count = 0, sum = 0, squares = 0;

    [[nodiscard]] double mean() const noexcept { return sum / count; }
    /// Of the sample; infinite of fewer than two members.
    [[nodiscard]] double variance() const noexcept {
        if (count < 2) return std::numeric_limits<double>::infinity();
        return std::max(0.0, squares - sum * sum / count) / (count - 1);
    }
};

/// By level; the event is that a value exceeds the threshold.
std::vector<LevelDifference> level_differences(const FinishedMembers& members, std::span<const float> values,
                                               double threshold) {
    std::vector<LevelDifference> levels;
    const auto happened = [&](std::size_t m) { return static_cast<double>(values[m]) > threshold ? 1 : 0; };
    for (std::size_t m = 0; m < values.size(); ++m) {
        if (members.weights[m] < 0) continue;  // belongs to the one before
        const bool is_pair = m + 1 < values.size() && members.weights[m + 1] < 0;
        const double difference = happened(m) - (is_pair ? happened(m + 1) : 0);
        levels.resize(std::max(levels.size(), members.levels[m] + 1));
        LevelDifference& level = levels[members.levels[m]];
        level.count += 1;
        level.sum += difference;
        level.squares += difference * difference;
    }
    return levels;
}

}  // namespace

MeanEstimate::MeanEstimate(const FinishedMembers& members)
    : members_(members),
      effective_size_(members.effective_size()),
      parts_(std::set<std::size_t>(members.replicates.begin(), members.replicates.end()).size()) {}

namespace {

/// k_normal's of Student's t distribution with 1, 2 ... degrees of freedom.
constexpr double k_student[] = {12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646};
static_assert(std::size(k_student) + 1 == k_replicates);
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
    if (parts_ == 0) {
        for (std::size_t m = 0; m < weights.size(); ++m)
            squares += weights[m] / all * (value(m) - estimate.value) * (value(m) - estimate.value);
        estimate.error = std::sqrt(squares / effective_size_);
        estimate.margin = k_normal * estimate.error;
    } else {
        std::array<double, k_replicates> differences{};
        for (std::size_t m = 0; m < weights.size(); ++m)
            differences[members_.replicates[m]] += weights[m] / all * (value(m) - estimate.value);
        for (const double difference : differences) squares += difference * difference;
        const auto parts = static_cast<double>(parts_);
        estimate.error =
            parts_ > 1 ? std::sqrt(parts / (parts - 1) * squares) : std::numeric_limits<double>::infinity();
        estimate.margin = parts_ > 1 ? k_student[parts_ - 2] * estimate.error : estimate.error;
    }
    return estimate;
}

Estimate MeanEstimate::probability(std::span<const float> values, double threshold) const {
    Estimate p;
    if (!members_.levels.empty()) {
        double squares = 0;
        for (const LevelDifference& level : level_differences(members_, values, threshold)) {
            p.value += level.mean();
            squares += level.variance() / level.count;
        }
        p.value = std::clamp(p.value, 0.0, 1.0);
        p.error = std::sqrt(squares);
        p.margin = k_normal * p.error;
    } else {
        p = of([&](std::size_t m) { return static_cast<double>(values[m]) > threshold ? 1.0 : 0.0; });
        const double nearer_half = (effective_size_ * p.value + 2) / (effective_size_ + 4);
        if (parts_ == 0) p.margin = k_normal * std::sqrt(nearer_half * (1 - nearer_half) / effective_size_);
    }
    if (!std::isfinite(p.error)) return {p.value, k_unknown_error, 1};
    constexpr double k_rounding = 1e-9;  // of sums of weights; no member has so little
    const bool is_alike = p.error < k_rounding;
    return {p.value, is_alike ? 0 : p.error, std::min(1.0, is_alike ? 3 / effective_size_ : p.margin)};
}

Estimate MeanEstimate::mean(std::span<const double> values) const {
    return of([&](std::size_t m) { return values[m]; });
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
        // Weights of a multilevel study have either sign: only with all members of a value is its sum meant.
        if (i + 1 < order.size() && values[order[i + 1]] == values[order[i]]) continue;
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

std::vector<double> level_variances(const FinishedMembers& members, Quantity quantity, const GridSpec& grid,
                                    const std::vector<double>& thresholds, std::size_t levels) {
    std::vector<double> sums(levels);
    for_each_reached_cell(members, quantity, grid, [&](std::size_t, std::span<const float> values) {
        for (const double threshold : thresholds) {
            const std::vector<LevelDifference> at = level_differences(members, values, threshold);
            for (std::size_t l = 0; l < at.size(); ++l)
                if (at[l].count > 1) sums[l] += at[l].variance();
        }
    });
    return sums;
}

namespace {

using Place = std::pair<std::size_t, std::size_t>;  // cell, feature

/// The values of the features from `first` to before `last`.
std::vector<float> values_of(const std::vector<std::string>& records, Quantity quantity, const GridSpec& grid,
                             const std::vector<std::vector<std::size_t>>& cells, std::size_t first, std::size_t last) {
    std::vector<Place> places;
    for (std::size_t feature = first; feature < last; ++feature)
        for (const std::size_t cell : cells[feature]) places.emplace_back(cell, feature - first);
    std::sort(places.begin(), places.end());
    const bool is_arrival = quantity == Quantity::arrival;
    const std::size_t count = records.size();
    std::vector<float> values((last - first) * count, is_arrival ? std::numeric_limits<float>::infinity() : 0.0F);
    for (std::size_t m = 0; m < count; ++m) {
        const MemberRecord record = require_record(records[m]);
        const std::vector<float>& of_member = record.of(quantity);
        if (of_member.empty()) continue;
        record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
            if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
            const auto cell = static_cast<std::size_t>(row * grid.columns + column);
            for (auto one = std::lower_bound(places.begin(), places.end(), Place{cell, 0});
                 one != places.end() && one->first == cell; ++one) {
                float& value = values[one->second * count + m];
                value = is_arrival ? std::min(value, of_member[index]) : std::max(value, of_member[index]);
            }
        });
    }
    return values;
}

}  // namespace

void for_each_feature(const std::vector<std::string>& records, Quantity quantity, const GridSpec& grid,
                      const std::vector<std::vector<std::size_t>>& cells,
                      const std::function<void(std::size_t feature, std::span<const float> values)>& visit) {
    if (records.empty()) return;
    const std::size_t at_once = std::max<std::size_t>(1, k_budget_bytes / (sizeof(float) * records.size()));
    for (std::size_t first = 0; first < cells.size(); first += at_once) {
        const std::size_t last = std::min(first + at_once, cells.size());
        const std::vector<float> values = values_of(records, quantity, grid, cells, first, last);
        for (std::size_t feature = first; feature < last; ++feature)
            visit(feature, {values.data() + (feature - first) * records.size(), records.size()});
    }
}

}  // namespace frana::app::study
