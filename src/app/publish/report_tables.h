// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/publish/report.h"

namespace frana::app {

// The parts of report.html as HTML tables and charts.

std::string results_table(const ReportInput& input);
/// Elevations and slopes under the release and along the path.
std::string ground_table(const SummaryFacts& facts);
/// The levels of numerics.accuracy with their cost, the estimate of each value, what is claimed.
std::string accuracy_tables(const AccuracyRecord& record);
std::string budget_table(const RunResult& result);
std::string numerics_table(const ReportInput& input);
/// Each area that failed: name, start, area, volume.
std::string release_table(const RunResult& result);
std::string hazard_table(const SceneSpec& spec, const std::vector<HazardArea>& areas);
std::string series_charts(const ReportInput& input);
std::string comparison_tables(const Comparison& comparison);
/// Returns every file read, with its CRS, the coordinate operation and its accuracy.
std::string inputs_table(const Prepared& prepared);
/// Returns every key of the scene: value, unit, origin, and the value chosen by frana for keys not given.
std::string parameters_table(const Prepared& prepared);

}  // namespace frana::app
