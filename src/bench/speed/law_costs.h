// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frana::bench {

/// What a law costs, one thread.
struct LawCost {
    std::string law;
    double nanoseconds = 0;  ///< processor time a particle-step
    double relative = 0;     ///< over the same flow without the law
    double bytes_per_particle = 0;
};

/// Runs speed_sheet with each law switched on alone and gives the times, the plain flow first. Variants take
/// turns, and each one's best of three is taken, so that what else the machine does weighs little.
/// @param particles of the sheet, @param steps of each turn
std::vector<LawCost> run_law_costs(double particles, std::int64_t steps);

std::string law_costs_csv(const std::vector<LawCost>& costs);
std::string law_costs_table(const std::vector<LawCost>& costs);

}  // namespace frana::bench
