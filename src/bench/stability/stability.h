// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/stability/stability_case.h"

namespace frana::bench {

/// One row of stability.csv. A case passes if nothing is non-finite, the volume is conserved to 1e-12, no speed exceeds
/// sqrt(2 g drop) + 2 sqrt(g depth), and its own value is within its limit.
struct StabilityRow {
    std::string case_name, what;
    bool passed = false;
    StabilityStatistic statistic;
    Soundness sound;
};

struct StabilityOptions {
    int threads = 1;
    std::vector<std::string> only;                   ///< names of cases; empty: all
    std::function<void(const std::string&)> report;  ///< called with one line for each finished case
};

std::vector<HardCase> hard_cases();

/// Runs the hard cases with the default scheme. Throws Error(input) for an unknown name.
std::vector<StabilityRow> run_stability(const StabilityOptions& options);

std::string stability_csv(const std::vector<StabilityRow>& rows);
std::string stability_table(const std::vector<StabilityRow>& rows);

}  // namespace frana::bench
