// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frana::bench {

/// The cost of a law, one thread.
struct LawCost {
    std::string law;
    double nanoseconds = 0;  ///< processor time per particle-step
    double relative = 0;     ///< over the same flow without the law
    double bytes_per_particle = 0;
};

/// Runs speed_sheet with each law switched on alone and returns the times, the plain flow first. Variants alternate,
/// and each one's best of three counts, so that other load of the machine has little effect.
/// @param particles of the sheet, @param steps of each turn
std::vector<LawCost> run_law_costs(double particles, std::int64_t steps);

std::string law_costs_csv(const std::vector<LawCost>& costs);
std::string law_costs_table(const std::vector<LawCost>& costs);

}  // namespace frana::bench
