// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/text/run_log.h"
#include "core/error.h"
#include "render/chart/chart.h"

namespace frana::app {

/// Returns the page of a chart without its panels, with the texts that maps have. Below the title: `note`, then the
/// scenario. At the foot: the chart's file, sources and author of the data; author and date.
/// @param note about this chart; empty: none
/// @param panels that it will have beside and below each other; 0: below each other
render::Chart chart_sheet(const MapSource& source, const std::string& what, const std::string& note,
                          const std::string& file, std::size_t panels = 0);

/// A chart with the name of its file.
struct NamedChart {
    std::string name;  ///< "profile_flow_path"
    render::Chart chart;
    std::string title{};  ///< what it shows
};

/// A kind of chart: the name of its file and its title, in the chart and on the page.
struct ChartTitle {
    const char *name, *title;  ///< title: worded()
};

/// A kind of chart of a study or a calibration. `draw` returns none if there is nothing to show.
template <class Data>
struct ChartRow {
    ChartTitle of;
    std::optional<render::Chart> (*draw)(const Data& data, const std::string& title, const MapSource& source);
};

template <class Rows>
std::vector<ChartTitle> titles_of(const Rows& rows) {
    std::vector<ChartTitle> titles;
    for (const auto& row : rows) titles.push_back(row.of);
    return titles;
}

/// Writes charts/NAME to a folder that has charts/. `for_page`: also the drawing of it in the report, whose letters are
/// legible there.
void write_chart(const NamedChart& one, const MapStyle& style, const std::string& folder, bool for_page);

/// The drawing of a chart in the report, as wide as its text.
std::string page_chart_svg(const render::Chart& chart);

/// Calls `draw` and notes it; returns false, with a warning, if `what` could not be drawn, whatever was thrown: a
/// picture never fails what was computed.
bool is_drawn(const std::string& what, Findings found, const std::function<void()>& draw);

/// Writes the charts of a study or a calibration to charts/ of its folder, with a warning of one that could not be
/// drawn.
template <class Rows, class Data>
void draw_chart_rows(const Rows& rows, const Data& data, const MapSource& source, const std::string& folder,
                     bool for_page, Findings found) {
    for (const auto& row : rows) {
        is_drawn("charts/" + std::string(row.of.name), found, [&] {
            if (auto chart = row.draw(data, source.style.words(row.of.title), source))
                write_chart({row.of.name, std::move(*chart)}, source.style, folder, for_page);
        });
    }
}

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
