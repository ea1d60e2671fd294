// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/calibration_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/pictures/charts.h"
#include "app/text/number_text.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/used_keys.h"

namespace frana::app::study {
namespace {

constexpr std::size_t k_most_panels = 9;
constexpr std::int64_t k_parts = 40;  // of a distribution
constexpr double k_most_weight = 0.9;
constexpr const auto& k_colours = render::k_chart_colours;
constexpr Rgb k_ink{20, 20, 20}, k_grey{150, 150, 150}, k_cloud{158, 202, 225};

/// What the charts of a calibration show.
struct CalibrationData {
    const CalibrationInput& input;
    const CalibrationResult& result;
};

/// The values of one key at places, for axes.
class KeyAxis {
  public:
    explicit KeyAxis(const KeySample& key) {
        StudySpec alone;
        alone.vary.push_back({key.key, key.prior});
        Places places;
        for (std::int64_t i = 0; i <= k_parts; ++i)
            places.push_back({std::clamp(static_cast<double>(i) / static_cast<double>(k_parts), 1e-6, 1 - 1e-6)});
        Problems none;
        for (const auto& row : samples_at(alone, places, "", none).numbers) values_.push_back(row[0]);
        scale = key.prior.law == Law::log_uniform || key.prior.law == Law::log_normal ? render::Scale::logarithmic
                                                                                      : render::Scale::linear;
    }
    [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

    render::Scale scale;

  private:
    std::vector<double> values_;
};

/// As column_of, in words.
std::string title_of_key(const CalibrationSpec& calibration, const KeySample& key, const Words& words) {
    const std::string title = title_in(key.key, words);
    return key.event.empty() || calibration.events.size() == 1 ? title : words("{1} of {2}", {title, key.event});
}

std::string axis_label(const CalibrationSpec& calibration, const KeySample& key, const Words& words) {
    const Parameter* const parameter = find_parameter(scene_parameters(), key.key);
    return with_unit(title_of_key(calibration, key, words), parameter == nullptr ? "" : parameter->unit);
}

/// Single points of one kind: breaks keep lines from joining them.
render::ChartSeries dots(const std::string& label, Rgb colour, const std::vector<Point>& points, render::Marker marker,
                         double size) {
    render::ChartSeries series{label, colour, {}, size};
    for (const Point& point : points) {
        series.points.push_back(point);
        series.points.push_back({k_no_data, k_no_data});
    }
    series.marker = marker;
    return series;
}

/// Members that together have most of the weight.
std::vector<bool> weightiest(const std::vector<double>& weights) {
    std::vector<std::size_t> order(weights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
    std::vector<bool> chosen(weights.size());
    double sum = 0;
    for (const std::size_t i : order) {
        if (sum >= k_most_weight || weights[i] == 0) break;
        chosen[i] = true;
        sum += weights[i];
    }
    return chosen;
}

render::ChartPanel response_panel(const CalibrationInput& input, const CalibrationResult& result, std::size_t first,
                                  std::size_t second, const Words& words) {
    const KeySample &a = result.keys[first], &b = result.keys[second];
    const KeyAxis x(a), y(b);
    render::ChartPanel panel{"", axis_label(input.spec(), a, words), axis_label(input.spec(), b, words), {}};
    panel.x = x.scale;
    panel.y = y.scale;
    panel.on_x = {x.values().front(), x.values().back()};
    panel.on_y = {y.values().front(), y.values().back()};
    const std::vector<bool> heavy = weightiest(result.weights);
    std::vector<Point> draws, some, others;
    constexpr std::size_t k_draws = 1000;
    for (const std::size_t i : drawn(result.weights_after, k_draws))
        draws.push_back({result.after[first].numbers[i], result.after[second].numbers[i]});
    for (std::size_t i = 0; i < result.weights.size(); ++i)
        (heavy[i] ? some : others).push_back({a.numbers[i], b.numbers[i]});
    panel.series.push_back(dots(words("posterior"), k_cloud, draws, render::Marker::circle, 0.4));
    panel.series.push_back(dots(words("other members"), k_grey, others, render::Marker::circle, 0.6));
    panel.series.push_back(dots(words("90 % of the weight"), k_colours[1], some, render::Marker::circle, 1));
    panel.series.push_back(
        dots(words("best"), k_ink, {{a.numbers[result.best], b.numbers[result.best]}}, render::Marker::diamond, 2));
    return panel;
}

std::optional<render::Chart> response(const CalibrationData& data, const std::string& title, const MapSource& source) {
    const CalibrationResult& result = data.result;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < result.keys.size(); ++a)
        for (std::size_t b = a + 1; b < result.keys.size(); ++b)
            if (!result.keys[a].prior.is_nominal() && !result.keys[b].prior.is_nominal()) pairs.emplace_back(a, b);
    if (pairs.empty()) return std::nullopt;
    // Those that the surveys determine best tell most.
    const auto width = [&](const auto& pair) {
        return result.posteriors[pair.first].width + result.posteriors[pair.second].width;
    };
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const auto& one, const auto& other) { return width(one) < width(other); });
    if (pairs.size() > k_most_panels) pairs.resize(k_most_panels);
    render::Chart chart =
        chart_sheet(source, title, source.style.words("pale: draws from the posterior; points: the members"),
                    "posterior.csv", pairs.size());
    for (const auto& [a, b] : pairs)
        chart.panels.push_back(response_panel(data.input, result, a, b, source.style.words));
    return chart;
}

std::vector<Point> staircase(const std::vector<double>& values, const std::vector<double>& weights) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<Point> points;
    double below = 0;
    for (const std::size_t i : order) {
        if (weights[i] == 0) continue;
        points.push_back({values[i], below});
        below = std::min(1.0, below + weights[i]);
        points.push_back({values[i], below});
    }
    return points;
}

std::optional<render::Chart> posterior(const CalibrationData& data, const std::string& title, const MapSource& source) {
    const CalibrationResult& result = data.result;
    std::vector<const KeySample*> keys;
    for (const KeySample& key : result.after)
        if (!key.prior.is_nominal() && keys.size() < k_most_panels) keys.push_back(&key);
    if (keys.empty()) return std::nullopt;
    const Words& words = source.style.words;
    render::Chart chart =
        chart_sheet(source, title, words("probability that the value is smaller"), "posterior.csv", keys.size());
    for (const KeySample* key : keys) {
        const KeyAxis axis(*key);
        render::ChartPanel panel{title_of_key(data.input.spec(), *key, words),
                                 axis_label(data.input.spec(), *key, words),
                                 words("probability [-]"),
                                 {},
                                 {0, 1}};
        panel.x = axis.scale;
        render::ChartSeries prior{words("before"), k_grey, {}};
        prior.stroke = render::Stroke::dashed;
        for (std::size_t i = 0; i < axis.values().size(); ++i)
            prior.points.push_back({axis.values()[i], static_cast<double>(i) / static_cast<double>(k_parts)});
        panel.series.push_back(std::move(prior));
        panel.series.push_back({words("after"), k_colours[0], staircase(key->numbers, result.weights_after), 2.6});
        chart.panels.push_back(std::move(panel));
    }
    return chart;
}

/// Every chart of a calibration, in the order of the page.
constexpr ChartRow<CalibrationData> k_calibration_charts[] = {
    {{"posterior", worded("values before and after the calibration")}, posterior},
    {{"response", worded("posterior over pairs of values")}, response},
};

}  // namespace

void draw_calibration_charts(const CalibrationInput& input, const CalibrationResult& result,
                             const ResultDirectory& directory, RunLog& log) {
    const SceneSpec& scene = input.own.front().base.spec;
    if (scene.output.maps.front() == "off" || !scene.output.charts) return;
    MapSource source;
    source.title = calibration_title(input);
    source.style = calibration_style(scene);
    directory.make_folder("charts");
    draw_chart_rows(k_calibration_charts, CalibrationData{input, result}, source, directory.folder(),
                    scene.output.report, log);
}

std::vector<ChartTitle> calibration_chart_titles() {
    return titles_of(k_calibration_charts);
}

}  // namespace frana::app::study
