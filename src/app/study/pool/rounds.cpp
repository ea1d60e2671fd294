// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/rounds.h"

#include <algorithm>
#include <cmath>

#include "app/study/plan/study_input.h"
#include "app/study/statistics/importance.h"
#include "app/study/statistics/outline_maps.h"

namespace frana::app::study {
namespace {

/// Mean particle-steps of the finished runs on the scene's own cells.
double own_cost(const StudyInput& input, const StudyResult& result) {
    double steps = 0, runs = 0;
    for (const std::size_t place : result.finished_at) {
        const SampleTable::LevelRun& run = input.table.level_runs[place];
        if (run.is_coarse || run.level + 1 < input.levels.size()) continue;
        steps += static_cast<double>(result.members[place].particle_steps);
        runs += 1;
    }
    return runs > 0 ? steps / runs : 0;
}

}  // namespace

std::vector<LevelSummary> level_summaries(const StudyInput& input, const StudyResult& result) {
    std::vector<LevelSummary> levels;
    if (input.levels.empty()) return levels;
    for (const LevelCells& cells : input.levels) levels.push_back({cells.cell_size, 0, 0, {}});
    for (std::size_t i = 0; i < result.members.size(); ++i) {
        const SampleTable::LevelRun& run = input.table.level_runs[i];
        if (!run.is_coarse) ++levels[run.level].statistics.members;
    }
    for (const std::size_t place : result.finished_at) {
        const SampleTable::LevelRun& run = input.table.level_runs[place];
        LevelSummary& level = levels[run.level];
        if (!run.is_coarse) ++level.members;
        level.statistics.cost += static_cast<double>(result.members[place].particle_steps);
    }
    for (LevelSummary& level : levels) {
        level.failed = level.statistics.members - level.members;
        if (level.members > 0) level.statistics.cost /= static_cast<double>(level.members);
    }
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        const LevelVariances variances =
            level_variances(result.finished, events.quantity, result.grid, events.thresholds, levels.size());
        for (std::size_t l = 0; l < levels.size(); ++l) levels[l].statistics.variance += variances.differences[l];
        levels.back().own_variance += variances.own;
    }
    levels.back().own_cost = own_cost(input, result);
    return levels;
}

double error_of_levels(const std::vector<LevelSummary>& levels) {
    double sum = 0;
    for (const LevelSummary& level : levels) sum += std::sqrt(level.statistics.variance * level.statistics.cost);
    return sum / std::sqrt(levels.back().own_variance * levels.back().own_cost);
}

bool run_levels(StudyInput& input, const std::string& folder, const std::function<bool(std::size_t)>& run_until,
                const std::function<bool(std::size_t)>& is_exact_enough) {
    if (!run_until(input.table.size())) return false;
    for (const double fraction : k_level_rounds) {
        if (is_exact_enough(input.table.size())) return true;
        add_level_members(input, folder, fraction);
        if (!run_until(input.table.size())) return false;
    }
    return true;
}

void add_level_members(StudyInput& input, const std::string& folder, double fraction) {
    const StudyResult result = read_study_result(input, folder, input.table.size());
    std::vector<LevelStatistics> levels;
    for (const LevelSummary& level : level_summaries(input, result)) levels.push_back(level.statistics);
    const double budget = fraction * static_cast<double>(input.reading.study.samples) * own_cost(input, result);
    const std::vector<std::size_t> members = allocate_members(levels, budget);
    for (std::size_t l = 0; l < levels.size(); ++l)
        append_members(input.level_draws[l], l, levels[l].members, std::min(members[l], input.level_draws[l].size()),
                       input.levels[l].cell_size, input.table);
}

bool run_importance(StudyInput& input, const std::string& folder, const std::function<bool(std::size_t)>& run_until) {
    ImportanceSampling sampling(input.reading.study);
    const RareEvent event = rare_event(input);
    for (;;) {
        if (!run_until(input.table.size())) return false;
        if (input.table.size() >= input.members()) return true;
        const StudyResult result = read_study_result(input, folder, input.table.size());
        std::vector<double> distances(input.table.size(), k_no_data);
        const std::vector<double> known = distances_from_outline(result.finished, Quantity::depth, event.threshold,
                                                                 result.grid, *cell_at(result.grid, event.place));
        for (std::size_t i = 0; i < known.size(); ++i) distances[result.finished_at[i]] = known[i];
        sampling.add_round(distances, input.table);
    }
}

}  // namespace frana::app::study
