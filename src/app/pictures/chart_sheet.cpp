// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/chart_sheet.h"

namespace frana::app {

render::Chart chart_sheet(const MapSource& source, const std::string& what, const std::string& note,
                          const std::string& file) {
    std::vector<std::string> parts{file, page_attribution(source)};
    for (std::string& line : block_lines(source.style)) parts.push_back(std::move(line));
    render::Chart chart;
    chart.title = page_title(source, what);
    chart.subtitle = note;
    chart.long_subtitle = foot_line({note, scenario_line(source)});
    chart.foot = foot_line(parts);
    chart.words = source.style.words;
    return chart;
}

}  // namespace frana::app
