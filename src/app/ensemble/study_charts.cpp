// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_charts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/pictures/chart_sheet.h"

namespace frana::app {
namespace {

constexpr std::size_t k_most_panels = 9;
constexpr const auto& k_colours = render::k_chart_colours;

render::Chart page(const MapSource& source, const std::string& what, const std::string& subtitle,
                   const std::string& file, int across) {
    render::Chart chart = chart_sheet(source, what, subtitle, file);
    chart.across = across;
    return chart;
}

int across_of(std::size_t panels) {
    return panels <= 1 ? 1 : panels <= 4 ? 2 : 3;
}

std::string axis_label(const study::Figure& figure, const Words& words) {
    return figure_title(figure, words) + (figure.unit.empty() || figure.unit == "-" ? "" : " [" + figure.unit + "]");
}

/// Fraction of the weight of members with more than each value: a staircase.
std::vector<Point> exceedance_curve(const std::vector<double>& values, const std::vector<double>& weights) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<Point> points;
    double above = 1;
    for (const std::size_t i : order) {
        points.push_back({values[i], std::max(0.0, above)});
        above -= weights[i];
        points.push_back({values[i], std::max(0.0, above)});
    }
    return points;
}

NamedChart exceedance_chart(const StudyResult& result, const MapSource& source) {
    const Words& words = source.style.words;
    render::Chart chart = page(source, words("exceedance"), words("fraction of the members with more than the value"),
                               "members.csv", across_of(std::min(k_most_panels, result.figures().size())));
    for (std::size_t f = 0; f < result.figures().size() && chart.panels.size() < k_most_panels; ++f) {
        const study::Figure& figure = result.figures()[f];
        render::ChartPanel panel{
            figure_title(figure, words), axis_label(figure, words), words("probability of more [-]"), {}, {0}};
        panel.series.push_back({"", k_colours[0], exceedance_curve(result.figure(f), result.finished.weights), 2.4});
        chart.panels.push_back(std::move(panel));
    }
    return {"exceedance", chart};
}

/// One bar for each key, from 0 to its value, with its interval as a thin line.
NamedChart sensitivity_chart(const StudyInput& input, const std::vector<FigureSensitivity>& figures, bool by_indices,
                             const MapSource& source) {
    const Words& words = source.style.words;
    render::Chart chart =
        page(source, words("sensitivity of the results"),
             words(by_indices ? worded("bar: total Sobol' index, thin line: its interval of 95 %, circle: first order")
                              : worded("bar: rank correlation with the figure, thin line: its interval of 95 %")),
             "sensitivity.csv", across_of(std::min(k_most_panels, figures.size())));
    for (const FigureSensitivity& figure : figures) {
        if (chart.panels.size() == k_most_panels) break;
        render::ChartPanel panel{figure_title(figure.figure, words),
                                 words(by_indices ? worded("fraction of the variance [-]") : worded("correlation [-]")),
                                 "",
                                 {}};
        panel.note = words("the figure does not vary");
        const double count = static_cast<double>(figure.keys.size());
        panel.has_rows = true;
        panel.on_y = {0.5, count + 0.5};
        panel.on_x = {by_indices ? 0 : -1.05, 1.05};
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const study::KeySensitivity& one = figure.keys[k];
            const auto& value = by_indices ? one.total : one.rank_correlation;
            if (!value) continue;
            const double y = count - static_cast<double>(k);
            const Rgb colour = k_colours[k % std::size(k_colours)];
            render::ChartSeries bar{input.table.keys[k], colour, {{0, y}, {value->value, y}}, 14};
            panel.series.push_back(std::move(bar));
            panel.series.push_back({"", {20, 20, 20}, {{value->low, y}, {value->high, y}}, 1.6});
            if (!by_indices) continue;
            render::ChartSeries first{"", {20, 20, 20}, {{one.first_order->value, y}}, 1};
            first.marker = render::Marker::circle;
            panel.series.push_back(std::move(first));
        }
        chart.panels.push_back(std::move(panel));
    }
    return {"sensitivity", chart};
}

NamedChart convergence_chart(const std::vector<ErrorAt>& convergence, const MapSource& source) {
    const Words& words = source.style.words;
    render::Chart chart =
        page(source, words("convergence of the probabilities"),
             words("standard error of the probabilities of depth over the map"), words("records of the members"), 1);
    render::ChartPanel panel{words("Standard error"), words("members"), words("standard error [-]"), {}};
    panel.x = panel.y = render::Scale::logarithmic;
    render::ChartSeries largest{words("largest"), k_colours[1], {}},
        mean{words("mean where it is not 0"), k_colours[0], {}};
    mean.stroke = render::Stroke::dashed;
    largest.marker = render::Marker::circle;
    mean.marker = render::Marker::square;
    for (const ErrorAt& at : convergence) {
        largest.points.push_back({static_cast<double>(at.members), at.error.largest});
        mean.points.push_back({static_cast<double>(at.members), at.error.mean});
    }
    panel.series = {largest, mean};
    chart.panels.push_back(std::move(panel));
    return {"convergence", chart};
}

/// The first members of a study that are independent of each other.
study::FinishedMembers independent_members(const StudyResult& result) {
    if (result.groups == 0) return result.finished;
    study::FinishedMembers first;
    for (std::size_t i = 0; i < result.groups; ++i) {  // of whole groups, in the order of members: matrix A
        first.records.push_back(result.design.records[i]);
        first.weights.push_back(1);
    }
    return first;
}

}  // namespace

std::string figure_title(const study::Figure& figure, const Words& words) {
    for (const char* of_a_place : {worded("greatest depth at gauge {1}"), worded("greatest speed at gauge {1}"),
                                   worded("greatest discharge through {1}"), worded("volume through {1}")}) {
        const std::string before(of_a_place, std::string(of_a_place).find("{1}"));
        if (figure.title.starts_with(before)) return words(of_a_place, {figure.title.substr(before.size())});
    }
    return words(figure.title);
}

std::vector<ErrorAt> convergence_of(const StudyInput& input, const StudyResult& result) {
    constexpr std::size_t k_first = 8;
    std::vector<ErrorAt> all;
    if (!input.levels.empty()) return all;  // its members are not exchangeable
    const study::FinishedMembers members = independent_members(result);
    for (std::size_t count = k_first;; count *= 2) {
        const std::size_t some = std::min(count, members.size());
        if (some < 2) break;
        all.push_back({some, study::error_of_first(members, some, study::Quantity::depth, result.grid,
                                                   input.base.spec.output.depth_thresholds)});
        if (some == members.size()) break;
    }
    return all;
}

std::vector<NamedChart> study_charts(const StudyInput& input, const StudyResult& result,
                                     const std::vector<FigureSensitivity>& sensitivities,
                                     const std::vector<ErrorAt>& convergence, const MapSource& source) {
    std::vector<NamedChart> charts;
    if (!result.figures().empty()) charts.push_back(exceedance_chart(result, source));
    if (!sensitivities.empty())
        charts.push_back(sensitivity_chart(input, sensitivities, input.table.groups > 0, source));
    if (!convergence.empty()) charts.push_back(convergence_chart(convergence, source));
    return charts;
}

}  // namespace frana::app
