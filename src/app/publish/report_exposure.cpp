// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_exposure.h"

#include <algorithm>
#include <cmath>

#include "app/publish/html_table.h"
#include "app/publish/report_scenario.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "core/markup.h"
#include "core/utf8.h"

namespace frana::app {
namespace {

/// A column of exposure.csv that reports show.
struct ShownColumn {
    const char *key, *title;
    int digits;
    double factor = 1;
};

constexpr ShownColumn k_columns[] = {{"max_depth_m", worded("Greatest depth [m]"), 3},
                                     {"max_velocity_ms", worded("Greatest speed [m/s]"), 3},
                                     {"max_pressure_kpa", worded("Greatest pressure [kPa]"), 3},
                                     {"arrival_s", worded("First arrival [s]"), 3},
                                     {"probability_reached", worded("Probability that it is reached [%]"), 3, 100},
                                     {"sources", worded("Slopes that reach it"), 6}};

std::optional<double> value_of(const ReachedFeature& feature, const std::string& key) {
    const auto found = std::find_if(feature.numbers.begin(), feature.numbers.end(),
                                    [&](const auto& number) { return number.first == key; });
    if (found == feature.numbers.end()) return std::nullopt;
    return found->second;
}

}  // namespace

std::string exposure_answer(const std::optional<ExposureTotals>& totals, ReachedBy by, const Words& words) {
    if (!totals) return "";
    return paragraph(words("What is exposed."), exposure_sentence(*totals, by, words));
}

std::string exposure_section(const std::optional<ExposureTotals>& totals, const Words& words) {
    if (!totals || totals->deepest.empty()) return "";
    std::vector<ShownColumn> shown;
    for (const ShownColumn& column : k_columns)
        if (value_of(totals->deepest.front(), column.key)) shown.push_back(column);
    std::vector<std::string> heads{words("Feature")};
    for (const ShownColumn& column : shown) heads.push_back(words(column.title));
    HtmlTable table(heads);
    for (const ReachedFeature& feature : totals->deepest) {
        std::vector<std::string> cells{valid_utf8(feature.name)};
        for (const ShownColumn& column : shown) {
            const double value = column.factor * value_of(feature, column.key).value_or(k_no_data);
            cells.push_back(std::isnan(value) ? "" : words.number(number_text(value, column.digits)));
        }
        table.row(cells);
    }
    const std::string all = totals->reached > totals->deepest.size()
                                ? words("The {1} deepest of {2}; {3} has all.",
                                        {std::to_string(totals->deepest.size()),
                                         words.number(grouped(static_cast<double>(totals->reached))), k_exposure_table})
                                : words("{1} has all features, also those that are not reached.", {k_exposure_table});
    return "<h2 id=\"exposure\">" + escaped_markup(words("Exposed features that are reached")) + "</h2>\n" +
           table.html() + "<p class=\"small\">" + escaped_markup(all) + "</p>\n";
}

}  // namespace frana::app
