// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/publish/report.h"

namespace frana::app {

// The tables of report.html after the answer, as HTML.

/// High values of depth, speed and pressure; the separate flows, gauges and cross-sections, if there are any.
std::string high_values_table(const ReportInput& input);
/// Elevations and slopes under the release and along the path.
std::string ground_table(const SummaryFacts& facts, const Words& words);
/// The levels of numerics.accuracy with their cost, the estimate of each value, what is claimed.
std::string accuracy_tables(const AccuracyRecord& record, const Words& words);
std::string budget_table(const RunResult& result, const Words& words);
std::string numerics_table(const ReportInput& input);
/// The physics and numerics that were computed.
std::string terms_note(const ReportInput& input);
/// Each area that failed: name, start, area, volume.
std::string release_table(const RunResult& result, const Words& words);
std::string hazard_table(const SceneSpec& spec, const std::vector<HazardArea>& areas, const Words& words);
/// Returns every file read, with its CRS, the coordinate operation and its accuracy; the comments of a preset.
std::string inputs_table(const Prepared& prepared, const Words& words);
/// Returns keys of the scene: value, unit, origin, and the value chosen by frana for keys not given.
/// @param only_used omits those that do not matter for the scene's numbers
std::string parameters_table(const Prepared& prepared, bool only_used, const Words& words);

}  // namespace frana::app
