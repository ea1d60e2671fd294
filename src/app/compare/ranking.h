// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/compare/comparison.h"

namespace frana::app {

/// Several comparisons in the order of their agreement: greatest Jaccard index first; those without a surveyed area
/// after them, by the mean distance of their fronts, nearest first.
class Ranking {
  public:
    /// Returns a folder name for a pair, different from all before: RESULT_SCAR, with a number if that is in use.
    [[nodiscard]] std::string folder_for(const std::string& result, const std::string& scar);
    void add(const std::string& folder, const std::string& simulated, const std::string& observed,
             const Comparison& comparison);
    /// Returns rank, folder, simulated, observed, threshold_m, jaccard, ... with empty cells for unknown values.
    [[nodiscard]] std::string csv() const;

  private:
    struct Entry {
        std::string folder, simulated, observed;
        Comparison comparison;
    };
    std::vector<std::string> folders_;
    std::vector<Entry> entries_;
};

}  // namespace frana::app
