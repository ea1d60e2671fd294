// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/study_check.h"

namespace frana::app {

/// What is known of a slope before it runs.
struct SlopePlan {
    double area = 0;               ///< of its polygons [m2]
    std::optional<Bounds> window;  ///< of the terrain; none: the whole DTM, or it fails
    std::string problem;           ///< why it fails; empty: it runs
};

/// Returns the plan of each slope of a region, in order.
std::vector<SlopePlan> slope_plans(const study::StudyInput& input);

/// Returns the time of all slopes together [s], by their areas.
double region_seconds(const std::vector<SlopePlan>& plans, const StudyForecast& forecast, int threads);

/// Prints the slopes of a region, the terrain of each, those that would fail and why, and the cost of all.
/// @param forecast of its largest slope
void print_region(const study::StudyInput& input, const std::vector<SlopePlan>& plans, const StudyForecast& forecast,
                  int threads, const std::string& target);

/// Returns the list `slopes` of --json.
Json slopes_json(const study::StudyInput& input, const std::vector<SlopePlan>& plans);

}  // namespace frana::app
