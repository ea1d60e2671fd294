// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
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
    /// @param scene values of the result's scene by key; empty: of another program
    void add(const std::string& folder, const std::string& simulated, const std::string& observed,
             const Comparison& comparison, std::map<std::string, std::string> scene = {});
    /// Returns rank, folder, simulated, observed, jaccard, ... with empty cells for unknown values; last a column for
    /// each key whose value differs between the scenes.
    [[nodiscard]] std::string csv() const;
    /// The same for a terminal: what varied and the main scores.
    [[nodiscard]] std::string table(std::size_t width) const;

  private:
    struct Entry {
        std::string folder, simulated, observed;
        Comparison comparison;
        std::map<std::string, std::string> scene;
        [[nodiscard]] std::string value(const std::string& key) const;
    };
    [[nodiscard]] std::vector<const Entry*> ordered() const;
    /// Keys whose value differs between the scenes; those of [output] change no score.
    [[nodiscard]] std::vector<std::string> varied() const;

    std::vector<std::string> folders_;
    std::vector<Entry> entries_;
};

}  // namespace frana::app
