// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/compare/probability_comparison.h"

namespace frana::app {

/// Puts the comparison of a map of probability with a survey into report.html of the study's result, as renew_page.
bool renew_report(const std::string& folder, const ProbabilityScores& scores, const ProbabilityMap& map);

}  // namespace frana::app
