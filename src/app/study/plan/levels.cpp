// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace frana::app::study {
namespace {

constexpr std::size_t k_least_pilot = 4, k_pilots_in_samples = 16;
constexpr std::size_t k_most_draws = 100'000;
constexpr std::size_t k_usual_cost_ratio = 8;  // four times the particles, twice the steps
constexpr std::int64_t k_level_seeds = 2147483648, k_seed_step = 1000003;

}  // namespace

std::vector<std::size_t> allocate_members(const std::vector<LevelStatistics>& levels, double budget) {
    std::vector<std::size_t> members;
    for (const LevelStatistics& level : levels) members.push_back(level.members);
    std::vector<bool> has_enough(levels.size());
    for (;;) {
        double left = budget, sum = 0;
        for (std::size_t l = 0; l < levels.size(); ++l) {
            if (has_enough[l])
                left -= static_cast<double>(levels[l].members) * levels[l].cost;
            else
                sum += std::sqrt(levels[l].variance * levels[l].cost);
        }
        if (!(sum > 0)) return members;
        bool settled = true;
        for (std::size_t l = 0; l < levels.size(); ++l) {
            if (has_enough[l]) continue;
            const double best = std::max(0.0, left) * std::sqrt(levels[l].variance / levels[l].cost) / sum;
            // What a level has beyond its part is missing to the others.
            if (best < static_cast<double>(levels[l].members)) {
                has_enough[l] = true;
                settled = false;
                members[l] = levels[l].members;
            } else {
                members[l] = static_cast<std::size_t>(best);
            }
        }
        if (settled) return members;
    }
}

std::vector<std::size_t> pilot_members(std::size_t samples, std::size_t levels) {
    std::vector<std::size_t> members(levels, std::max(k_least_pilot, samples / k_pilots_in_samples));
    for (std::size_t l = levels - 1; l-- > 0;) members[l] = 2 * members[l + 1];
    return members;
}

std::vector<SampleTable> draw_levels(const StudySpec& study, const std::string& label, Problems& problems) {
    const std::size_t levels = *study.levels;
    std::vector<SampleTable> draws;
    std::size_t most = static_cast<std::size_t>(study.samples);
    for (std::size_t l = levels; l-- > 0; most = std::max(most, std::min(k_usual_cost_ratio * most, k_most_draws))) {
        StudySpec one = study;
        one.samples = static_cast<std::int64_t>(most);
        one.seed = (study.seed + static_cast<std::int64_t>(l) * k_seed_step) % k_level_seeds;
        Problems of_level;
        draws.insert(draws.begin(), draw_samples(one, label, of_level));
        if (of_level.empty()) continue;
        for (const Problem& problem : of_level.list()) problems.add(problem);  // of one level: they are alike
        return {};
    }
    return draws;
}

void append_members(const SampleTable& draws, std::size_t level, std::size_t first, std::size_t last, double cell_size,
                    SampleTable& table) {
    table.keys = draws.keys;
    table.nominal = draws.nominal;
    table.is_replicated = draws.is_replicated;
    for (std::size_t i = first; i < last; ++i) {
        for (const bool is_coarse : {false, true}) {
            if (is_coarse && level == 0) continue;
            table.values.push_back(draws.values[i]);
            table.numbers.push_back(draws.numbers[i]);
            table.weights.push_back(1);
            table.level_runs.push_back({level, is_coarse, is_coarse ? 2 * cell_size : cell_size, i});
        }
    }
}

}  // namespace frana::app::study
