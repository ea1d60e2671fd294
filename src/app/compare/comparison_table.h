// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "analysis/probability_scores.h"
#include "app/compare/comparison.h"

namespace frana::app {

/// Returns the scores of a comparison for a terminal of this width.
std::string comparison_table(const Comparison& comparison, const ComparisonInput& input, std::size_t width);
/// The same of a map of probability.
std::string probability_table(const ProbabilityScores& scores, std::size_t width);

}  // namespace frana::app
