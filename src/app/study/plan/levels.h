// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/study/plan/sampling.h"

namespace frana::app::study {

// Multilevel Monte Carlo (Giles 2008, Operations Research 56, 607): the expectation on the scene's own cells is that on
// coarse cells plus the expected differences between each cell size and the next coarser one,
//
//     E[P_L] = E[P_0] + sum over l = 1..L of E[P_l - P_(l-1)],
//
// each estimated from members of its own. A difference varies little, so few of its expensive members suffice. Level 0
// has the largest cells; from level to level their side halves. A member of level 0 is one run; of the others a pair of
// runs with the same values, on the cells of the level and on the next coarser ones.

/// What is known of a level.
struct LevelStatistics {
    std::size_t members = 0;  ///< so far
    double variance = 0;      ///< of the difference: the sum over all cells and events
    double cost = 0;          ///< of a member, in any unit
};

/// Returns the total number of members of each level that, within a budget (in the unit of the costs), makes the
/// variance of the sum least: in proportion to sqrt(variance / cost), but no fewer than there are.
std::vector<std::size_t> allocate_members(const std::vector<LevelStatistics>& levels, double budget);

/// Returns the number of members of each level from which variances and costs are first measured.
std::vector<std::size_t> pilot_members(std::size_t samples, std::size_t levels);

/// Draws for each level, from a seed of its own, as many members as the whole budget could pay if halved cells cost
/// eight times as much, at most a hundred thousand.
std::vector<SampleTable> draw_levels(const StudySpec& study, const std::string& label, Problems& problems);

/// Appends some of a level's members to a table, each with its runs: the finer one first.
/// @param cell_size of the level; 0: not known yet, the runs have the scene's own
void append_members(const SampleTable& draws, std::size_t level, std::size_t first, std::size_t last, double cell_size,
                    SampleTable& table);

}  // namespace frana::app::study
