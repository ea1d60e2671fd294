// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/study/openturns/functions.h"

namespace frana::app::study {

/// Returns Sobol' indices by Martinez's estimator (2011), for one or more outputs; of a single one with
/// intervals from the estimator's asymptotic distribution.
/// @param points rows of Saltelli's design: A, B, then A with one column of B each
/// @param outputs by output and row
/// @param groups rows of A
/// @return by output and key
std::vector<std::vector<KeySensitivity>> sobol_indices(const DesignPoints& points,
                                                       const std::vector<std::vector<double>>& outputs,
                                                       std::size_t groups);

/// Rank correlations of inputs with outputs, for independent members of equal weight.
class RankCorrelations {
  public:
    explicit RankCorrelations(const DesignPoints& points);
    /// @param output by member
    /// @return by key
    [[nodiscard]] std::vector<KeySensitivity> with(const std::vector<double>& output) const;
    /// Returns the correlation of a key with an event of which it is known in which members it happened: the same for
    /// an output of 0 and 1, without sorting. NaN if it happened in all or in none.
    [[nodiscard]] double with_event(std::size_t key, const std::vector<char>& happened) const;

  private:
    std::vector<bool> nominal_;                 ///< by key
    std::vector<std::vector<double>> columns_;  ///< by key and member: ranks; of a key without order its classes
    std::vector<bool> measurable_;              ///< by key: not a class of its own in every member
};

}  // namespace frana::app::study
