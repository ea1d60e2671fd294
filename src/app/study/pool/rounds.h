// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/study/plan/levels.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"

namespace frana::app::study {

/// Fractions of the budget of a multilevel study after which its levels are measured again, to share out the next part.
/// The first round is the pilot.
inline constexpr double k_level_rounds[] = {0.25, 0.5, 1};

/// What one level of a multilevel study gave.
struct LevelSummary {
    double cell_size = 0;     ///< [m]
    std::size_t members = 0;  ///< finished
    std::size_t failed = 0;   ///< of which a run failed
    /// Of the difference of the level, summed over all cells and events; cost: particle-steps of a member.
    LevelStatistics statistics;
    /// Of the finest level: what a run on the scene's own cells costs, and its variance likewise.
    double own_cost = 0, own_variance = 0;
};
/// Empty for other studies.
std::vector<LevelSummary> level_summaries(const StudyInput& input, const StudyResult& result);

/// Returns the standard error of levels over that of independent members on the scene's own cells, both at the same
/// cost: sum over the levels of sqrt(V_l C_l), over sqrt(V C).
double error_of_levels(const std::vector<LevelSummary>& levels);

/// Runs a multilevel study round by round: first the pilot, then what add_level_members adds.
/// @param run_until runs the members below a number; false: stopped by a signal
/// @param is_exact_enough looked at after every round, with the number of members
/// @return false if it was stopped
bool run_levels(StudyInput& input, const std::string& folder, const std::function<bool(std::size_t)>& run_until,
                const std::function<bool(std::size_t)>& is_exact_enough);

/// Appends members to the study's table: shares out a fraction of the budget, study.samples runs on the scene's own
/// cells, by what the runs so far have cost and how their results vary. Costs are counted in particle-steps, so that
/// the same study has the same members on any machine.
void add_level_members(StudyInput& input, const std::string& folder, double fraction);

/// Runs a study by importance sampling: each round follows from the runs of those before (ImportanceSampling), with
/// their distances from the study's rare place. Returns false if it was stopped.
bool run_importance(StudyInput& input, const std::string& folder, const std::function<bool(std::size_t)>& run_until);

}  // namespace frana::app::study
