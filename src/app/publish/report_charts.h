// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/publish/report.h"
#include "render/chart/chart.h"

namespace frana::app {

/// Returns a chart of one pair of axes as a figure, each curve with its own stroke or markers, so that they are told
/// apart without colours. Of many curves there are several charts, each with few.
/// @param alt what it shows
Document chart_figures(const render::ChartPanel& panel, const std::string& alt, const Words& words);

/// Front, speed and depth over time; depths at the gauges and discharges through the cross-sections.
Document series_charts(const ReportInput& input);

/// Scores over the depth threshold.
Document score_chart(const std::vector<ComparisonStatistics>& curve, const Words& words);

}  // namespace frana::app
