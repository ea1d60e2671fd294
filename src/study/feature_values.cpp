// SPDX-License-Identifier: Apache-2.0
#include "study/feature_values.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.h"

namespace frana::study {
namespace {

constexpr std::size_t k_budget_bytes = 256'000'000;

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
        const auto record = read_record(records[m]);
        if (!record)
            throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", records[m], "", "",
                                                        "Check the disk; --resume computes that member again"});
        const std::vector<float>& of_member = record->of(quantity);
        if (of_member.empty()) continue;
        record->for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
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

}  // namespace frana::study
