// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/calibrate/calibration_result.h"
#include "app/pictures/charts.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// Draws the charts of a calibration, if the scene asks for any: `forecast`, the scores of each event, fitted and
/// predicted from the others; `posterior`, the distribution of each key before and after; `response`, the score over
/// pairs of keys. Returns false if one could not be drawn, with a warning.
bool draw_calibration_charts(const CalibrationInput& input, const CalibrationRuns& runs,
                             const CalibrationResult& result, const ResultDirectory& directory, RunLog& log);

/// Returns those that a calibration may have, in the order of the page.
std::vector<ChartTitle> calibration_chart_titles();

/// Returns the mean score round the centres of n x n equal parts of the distributions of two keys, from the members of
/// a stage: weighted by exp(-r^2 / (2 b^2)) over the distance r in places, b = 0.08. Row 0 has the greatest places of
/// the second key. NaN if no member finished.
Raster smoothed_scores(const std::vector<double>& first, const std::vector<double>& second,
                       const std::vector<double>& scores, std::int64_t n);

}  // namespace frana::app
