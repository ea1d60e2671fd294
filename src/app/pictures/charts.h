// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "core/error.h"
#include "render/chart/chart.h"

namespace frana::app {

/// Returns the page of a chart without its panels, with the texts that maps have. Below the title: `note`, then the
/// scenario. At the foot: the chart's file, sources and author of the data; organisation, author and date.
/// @param note about this chart; empty: none
render::Chart chart_sheet(const MapSource& source, const std::string& what, const std::string& note,
                          const std::string& file);

/// A chart with the name of its file.
struct NamedChart {
    std::string name;  ///< "profile_flow_path"
    render::Chart chart;
};

/// Writes charts/NAME to a folder that has charts/. `for_page`: also the drawing of it in the report, whose letters are
/// legible there.
void write_chart(const NamedChart& one, const MapStyle& style, const std::string& folder, bool for_page);

/// The drawing of a chart in the report, as wide as its text.
std::string page_chart_svg(const render::Chart& chart);

/// Returns every chart of a result's tables: a longitudinal profile for each line of profiles.csv (bed, initial and
/// final surface, greatest depth: the left part of the publication's Figure 8), the series over time, gauges,
/// cross-sections, and with a survey the scores over the depth threshold. The numbers are those of the files. A broken
/// table is a problem and does not affect the other charts.
std::vector<NamedChart> result_charts(const ResultReader& result, const MapSource& source, Problems& problems);

/// Returns their files in a folder.
std::vector<std::string> chart_files(const ResultReader& result, const MapSource& source, const std::string& folder);

/// Draws them to an existing folder and returns the names of the files; a chart that cannot be drawn is a problem and
/// does not affect the others. Throws Error(environment).
std::vector<std::string> draw_charts(const ResultReader& result, const MapSource& source, const std::string& folder,
                                     Problems& problems);

}  // namespace frana::app
