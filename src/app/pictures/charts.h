// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/pictures/result_reader.h"
#include "core/error.h"
#include "render/chart/chart.h"

namespace frana::app {

/// A chart with the name of its file.
struct NamedChart {
    std::string name;  ///< "profile_flow_path"
    render::Chart chart;
};

/// Every chart that a result's tables give: a longitudinal profile for each line of profiles.csv (bed,
/// initial and final surface, greatest depth: the left part of the publication's Figure 8), the series over
/// time, gauges, cross-sections, and where there was a survey the scores over the depth threshold. The
/// numbers are those of the files. A broken table is a problem and costs no other's charts.
std::vector<NamedChart> result_charts(const ResultReader& result, const MapSource& source, Problems& problems);

/// The files that they become in a folder.
std::vector<std::string> chart_files(const ResultReader& result, const MapSource& source, const std::string& folder);

/// Draws them into a folder that exists and returns the names of the files; a chart that cannot be drawn is a problem
/// and costs no other. Throws Error(environment).
std::vector<std::string> draw_charts(const ResultReader& result, const MapSource& source, const std::string& folder,
                                     Problems& problems);

}  // namespace frana::app
