// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/result_reader.h"
#include "render/line_chart.h"

namespace frana::app {

/// A chart with the name of its file.
struct NamedChart {
    std::string name;  ///< "profile_flow_path"
    render::CurveChart chart;
};

/// Every chart that a result's tables give: a longitudinal profile for each line of profiles.csv (bed,
/// initial and final surface, greatest depth: the left part of the publication's Figure 8), the series over
/// time, gauges, cross-sections, and where there was a survey the scores over the depth threshold. The
/// numbers are those of the files. Throws Error(input) for a broken table.
std::vector<NamedChart> result_charts(const ResultReader& result, const MapSource& source);

/// The files that they become in a folder.
std::vector<std::string> chart_files(const ResultReader& result, const MapSource& source, const std::string& folder);

/// Draws them into a folder that exists and returns the names of the files.
std::vector<std::string> draw_charts(const ResultReader& result, const MapSource& source,
                                     const std::string& folder);

}  // namespace frana::app
