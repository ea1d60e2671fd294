// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_charts.h"

#include <algorithm>

#include "app/publish/html_page.h"
#include "app/publish/report_answer.h"
#include "app/text/number_text.h"
#include "core/text.h"

namespace frana::app {
namespace {

constexpr int k_width = 360, k_height = 180;
constexpr std::size_t k_curves = 8, k_curve_letters = 30;

double greatest(const std::vector<Point>& points) {
    double value = 0;
    for (const Point p : points) value = std::max(value, p.y);
    return value;
}

/// Three digits; of greater values every one, in groups.
std::string greatest_text(const std::vector<Point>& points, const Words& words) {
    const double value = greatest(points);
    return words.number(value < 1000 ? number_text(value, 3) : grouped(value));
}

}  // namespace

Document chart_figures(const render::ChartPanel& panel, const std::string& alt, const Words& words) {
    Document figures;
    for (std::size_t first = 0; first < std::max<std::size_t>(1, panel.series.size()); first += k_curves) {
        render::ChartPanel part = panel;
        part.series.clear();
        for (std::size_t i = first; i < std::min(first + k_curves, panel.series.size()); ++i) {
            part.series.push_back(panel.series[i]);
            part.series.back().width_px = 3;
            render::look_apart(part.series.back(), i - first);
        }
        figures.add(Figure{"", "", alt,
                           render::chart_svg({"", "", "", 1, {std::move(part)}, false, words}, k_width, k_height)});
    }
    return figures;
}

Document series_charts(const ReportInput& input) {
    const Words& words = input.words;
    const std::string seconds = words("time [s]");
    Document charts;
    const auto add = [&](const std::string& label, double SeriesRow::*value) {
        render::ChartSeries series;
        for (const SeriesRow& row : input.result.series) series.points.push_back({row.time, row.*value});
        const std::string most = greatest_text(series.points, words);
        render::ChartPanel panel{"", seconds, label, {std::move(series)}, {0}};
        charts.add(chart_figures(panel, words("Curve over time: {1}, at most {2}", {label, most}), words));
    };
    add(words("front from the release's centroid [m]"), &SeriesRow::front_distance);
    add(words("greatest speed [m/s]"), &SeriesRow::max_speed);
    add(words("greatest depth [m]"), &SeriesRow::max_depth);
    add(words("covered area [m²]"), &SeriesRow::covered_area);
    const auto named = [](const auto& places) {
        std::vector<render::ChartSeries> series;
        for (const auto& place : places)
            series.push_back({elided(valid_utf8(place.name), k_curve_letters), render::k_chart_colours[0], {}});
        return series;
    };
    const auto add_places = [&](const std::string& label, std::vector<render::ChartSeries> series) {
        if (series.empty()) return;
        std::string alt = words("Curves over time: {1}", {label});
        for (const render::ChartSeries& one : series)
            alt += "; " + one.label + ": " + words("at most {1}", {greatest_text(one.points, words)});
        charts.add(chart_figures({"", seconds, label, std::move(series), {0}}, alt, words));
    };
    const Recording& recording = input.prepared.scene.recording;
    std::vector<render::ChartSeries> gauges = named(recording.gauges), sections = named(recording.sections);
    for (const GaugeRow& row : input.result.gauges) gauges[row.gauge].points.push_back({row.time, row.depth});
    for (const SectionRow& row : input.result.sections)
        sections[row.section].points.push_back({row.time, row.discharge});
    add_places(words("depth at the gauges [m]"), std::move(gauges));
    add_places(words("discharge through the cross-sections [m³/s]"), std::move(sections));
    return Document().columns(std::move(charts));  // beside each other, where there is room
}

Document score_chart(const std::vector<ComparisonStatistics>& curve, const Words& words) {
    render::ChartSeries jaccard, hit, alarm;
    jaccard.label = "Jaccard";
    hit.label = words("true positive rate");
    alarm.label = words("false positive rate");
    for (const ComparisonStatistics& f : curve) {
        jaccard.points.push_back({f.threshold_m, f.jaccard});
        hit.points.push_back({f.threshold_m, f.true_positive_rate});
        alarm.points.push_back({f.threshold_m, f.false_positive_rate});
    }
    const std::string alt = words("Scores over the depth threshold; the greatest Jaccard index is {1}",
                                  {words.number(number_text(greatest(jaccard.points), 3))});
    render::ChartPanel panel{"", words("depth threshold [m]"), words("score"), {jaccard, hit, alarm}, {0}};
    panel.x = render::Scale::logarithmic;
    return chart_figures(panel, alt, words);
}

}  // namespace frana::app
