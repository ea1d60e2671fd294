// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/region_report.h"

#include <algorithm>

#include "app/publish/html_table.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "core/markup.h"
#include "core/utf8.h"

namespace frana::app {
namespace {

/// A figure of members.csv that the table shows.
struct ShownFigure {
    const char *key, *title;
    bool in_groups;  ///< "1 000", else three digits
};

constexpr ShownFigure k_figures[] = {{"volume_m3", worded("Volume [m³]"), true},
                                     {"runout_m", worded("Run-out [m]"), true},
                                     {"max_depth_m", worded("Greatest depth [m]"), false},
                                     {"max_velocity_ms", worded("Greatest speed [m/s]"), false}};

std::string figure_text(const MemberResult& member, const ShownFigure& shown, const Words& words) {
    for (const study::Figure& figure : member.figures)
        if (figure.key == shown.key)
            return words.number(shown.in_groups ? grouped(figure.value) : number_text(figure.value, 3));
    return "";
}

}  // namespace

std::string slopes_section(const StudyInput& input, const StudyResult& result, const Words& words) {
    if (input.slopes.empty()) return "";
    const bool has_scenarios = input.reading.study.region->scenario.has_value(), has_failures = result.failed() > 0;
    std::vector<std::string> heads{"", words("Slope")};
    if (has_scenarios) heads.push_back(words("Scenario"));
    for (const ShownFigure& shown : k_figures) heads.push_back(words(shown.title));
    if (has_failures) heads.push_back(words("Why it failed"));
    HtmlTable table(heads);
    for (std::size_t i = 0; i < std::min(k_most_slopes, result.members.size()); ++i) {
        const MemberResult& member = result.members[i];
        const Slope& slope = input.slopes[member.member];
        std::vector<std::string> cells{std::to_string(member.member), valid_utf8(slope.name)};
        if (has_scenarios) cells.push_back(valid_utf8(slope.scenario));
        // The figures of a run that failed are those of another event.
        for (const ShownFigure& shown : k_figures)
            cells.push_back(member.failure.empty() ? figure_text(member, shown, words) : "");
        if (has_failures) cells.push_back(member.failure);
        table.row(cells, member.failure.empty() ? "" : "warning");
    }
    std::string html = "<h2 id=\"slopes\">" + escaped_markup(words("Slopes")) + "</h2>\n" + table.html();
    if (result.members.size() > k_most_slopes)
        html +=
            "<p class=\"small\">" +
            escaped_markup(words("The first {1} of {2} slopes; {3} has all.",
                                 {std::to_string(k_most_slopes),
                                  words.number(grouped(static_cast<double>(result.members.size()))), k_member_table})) +
            "</p>\n";
    return html;
}

}  // namespace frana::app
