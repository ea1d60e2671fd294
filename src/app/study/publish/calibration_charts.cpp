// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/calibration_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

#include "app/pictures/charts.h"
#include "app/text/number_text.h"
#include "params/keys/scene_parameters.h"
#include "render/map/relief.h"

namespace frana::app::study {
namespace {

constexpr std::size_t k_most_panels = 9, k_most_levels = 6;
constexpr std::int64_t k_parts = 40;  // of a distribution, for contours
constexpr double k_reach = 0.08;      // of a member's score, in places
constexpr double k_most_weight = 0.9;
constexpr const auto& k_colours = render::k_chart_colours;
constexpr Rgb k_ink{20, 20, 20}, k_grey{150, 150, 150};
// From pale to dark: greater scores are darker.
constexpr Rgb k_levels[] = {{198, 219, 239}, {158, 202, 225}, {107, 174, 214},
                            {66, 146, 198},  {33, 113, 181},  {8, 69, 148}};

/// What the charts of a calibration show.
struct CalibrationData {
    const CalibrationInput& input;
    const CalibrationRuns& runs;
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
    [[nodiscard]] double at(double place) const {
        const double index = std::clamp(place, 0.0, 1.0) * static_cast<double>(k_parts);
        const auto below = std::min(static_cast<std::size_t>(index), values_.size() - 2);
        const double part = index - static_cast<double>(below);
        return values_[below] + part * (values_[below + 1] - values_[below]);
    }
    [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

    render::Scale scale;

  private:
    std::vector<double> values_;
};

std::string axis_label(const CalibrationSpec& calibration, const KeySample& key) {
    static const std::vector<Parameter>& k_parameters = scene_parameters();
    const Parameter* const parameter = find_parameter(k_parameters, key.key);
    const std::string unit = parameter == nullptr ? "" : parameter->unit;
    return column_of(calibration, key) + (unit.empty() ? "" : " [" + unit + "]");
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

/// A round interval that gives at most so many contours.
double contour_interval(double low, double high) {
    for (double decade = 1e-4;; decade *= 10)
        for (const double step : {1.0, 2.0, 5.0})
            if ((high - low) / (step * decade) <= static_cast<double>(k_most_levels)) return step * decade;
}

void add_contours(const Raster& scores, const KeyAxis& x, const KeyAxis& y, const Words& words,
                  render::ChartPanel& panel) {
    double low = 1, high = 0;
    scores.values.for_each_stored([&](std::size_t, double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    });
    if (!(high > low)) return;
    std::map<double, render::ChartSeries> by_level;
    for (const render::Contour& line : render::contour_lines(scores, contour_interval(low, high))) {
        render::ChartSeries& series = by_level.try_emplace(line.level).first->second;
        for (const Point& point : line.points) series.points.push_back({x.at(point.x), y.at(point.y)});
        series.points.push_back({k_no_data, k_no_data});
    }
    std::size_t index = std::size(k_levels) - std::min(std::size(k_levels), by_level.size());
    for (auto& [level, series] : by_level) {
        series.label = words("score {1}", {words.number(number_text(level, 3))});
        series.colour = k_levels[std::min(index++, std::size(k_levels) - 1)];
        series.width_px = 2.6;
        panel.series.push_back(std::move(series));
    }
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

std::vector<double> places_of(const Stage& stage, const CalibrationInput& input, const KeySample& key) {
    std::vector<double> places;
    const auto& events = input.spec().events;
    std::size_t event = 0;
    while (!key.event.empty() && events[event].name != key.event) ++event;
    const SampleTable& table = stage.tables[event];
    const auto column =
        static_cast<std::size_t>(std::find(table.keys.begin(), table.keys.end(), key.key) - table.keys.begin());
    for (const auto& place : table.places) places.push_back(place[column]);
    return places;
}

std::vector<double> scores_of(const Stage& stage) {
    std::vector<double> scores;
    for (const auto& misfits : stage.misfits()) scores.push_back(score_of(misfits));
    return scores;
}

render::ChartPanel response_panel(const CalibrationInput& input, const CalibrationRuns& runs,
                                  const CalibrationResult& result, std::size_t first, std::size_t second,
                                  const Words& words) {
    const KeySample &a = result.keys[first], &b = result.keys[second];
    const KeyAxis x(a), y(b);
    render::ChartPanel panel{"", axis_label(input.spec(), a), axis_label(input.spec(), b), {}};
    panel.x = x.scale;
    panel.y = y.scale;
    panel.on_x = {x.at(0), x.at(1)};
    panel.on_y = {y.at(0), y.at(1)};
    const std::vector<bool> heavy = weightiest(result.weights);
    std::vector<Point> some, others;
    for (std::size_t i = 0; i < result.weights.size(); ++i)
        (heavy[i] ? some : others).push_back({a.numbers[i], b.numbers[i]});
    panel.series.push_back(dots(words("other members"), k_grey, others, render::Marker::circle, 0.6));
    add_contours(smoothed_scores(places_of(runs.design, input, a), places_of(runs.design, input, b),
                                 scores_of(runs.design), k_parts),
                 x, y, words, panel);
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
    render::Chart chart = chart_sheet(
        source, title,
        source.style.words("contours: mean score of the first members; points: the members of the posterior"),
        "design.csv, posterior.csv", pairs.size());
    for (const auto& [a, b] : pairs)
        chart.panels.push_back(response_panel(data.input, data.runs, result, a, b, source.style.words));
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
    for (const KeySample& key : result.keys)
        if (!key.prior.is_nominal() && keys.size() < k_most_panels) keys.push_back(&key);
    if (keys.empty()) return std::nullopt;
    const Words& words = source.style.words;
    render::Chart chart =
        chart_sheet(source, title, words("probability that the value is smaller"), "posterior.csv", keys.size());
    for (const KeySample* key : keys) {
        const KeyAxis axis(*key);
        render::ChartPanel panel{column_of(data.input.spec(), *key),
                                 axis_label(data.input.spec(), *key),
                                 words("probability [-]"),
                                 {},
                                 {0, 1}};
        panel.x = axis.scale;
        render::ChartSeries prior{words("before"), k_grey, {}};
        prior.stroke = render::Stroke::dashed;
        for (std::size_t i = 0; i < axis.values().size(); ++i)
            prior.points.push_back({axis.values()[i], static_cast<double>(i) / static_cast<double>(k_parts)});
        panel.series.push_back(std::move(prior));
        panel.series.push_back({words("after"), k_colours[0], staircase(key->numbers, result.weights), 2.6});
        chart.panels.push_back(std::move(panel));
    }
    return chart;
}

/// One row for each event and kind of score: a bar from the 5 to the 95 % quantile, the score of the best values.
std::optional<render::Chart> forecast(const CalibrationData& data, const std::string& title, const MapSource& source) {
    const CalibrationInput& input = data.input;
    const CalibrationResult& result = data.result;
    if (input.events() < 2) return std::nullopt;
    const Words& words = source.style.words;
    render::Chart chart = chart_sheet(
        source, title, words("bar: scores of 5 to 95 % of the weight; diamond: of the best values; 1 agrees"),
        "calibration.json", 1);
    render::ChartPanel panel{"", words("score [-]"), "", {}};
    panel.has_rows = true;
    panel.on_x = {0, 1};
    const double count = 2 * static_cast<double>(input.events());
    panel.on_y = {0.5, count + 0.5};
    double y = count;
    for (std::size_t e = 0; e < input.events(); ++e) {
        const std::array<std::pair<const char*, const Explained*>, 2> kinds{
            {{worded("{1}, fitted"), &result.events[e].fitted},
             {worded("{1}, predicted"), &result.events[e].predicted}}};
        for (std::size_t k = 0; k < 2; ++k, --y) {
            const Explained& one = *kinds[k].second;
            if (!one.possible) continue;
            panel.series.push_back({words(kinds[k].first, {input.spec().events[e].name}),
                                    k_colours[(2 * e + k) % std::size(k_colours)],
                                    {{one.low, y}, {one.high, y}},
                                    14});
            panel.series.push_back(dots("", k_ink, {{one.best_score, y}}, render::Marker::diamond, 2));
        }
    }
    chart.panels.push_back(std::move(panel));
    return chart;
}

/// Every chart of a calibration, in the order of the page.
constexpr ChartRow<CalibrationData> k_calibration_charts[] = {
    {{"forecast", worded("fitted, and predicted from the other events")}, forecast},
    {{"posterior", worded("values before and after the calibration")}, posterior},
    {{"response", worded("score over pairs of values")}, response},
};

}  // namespace

Raster smoothed_scores(const std::vector<double>& first, const std::vector<double>& second,
                       const std::vector<double>& scores, std::int64_t n) {
    GridSpec grid;
    grid.north = 1;
    grid.cell_size = 1 / static_cast<double>(n);
    grid.columns = grid.rows = n;
    Raster smooth(grid, k_no_data);
    for (std::int64_t row = 0; row < n; ++row) {
        for (std::int64_t column = 0; column < n; ++column) {
            const Point centre = grid.cell_centre(row, column);
            double sum = 0, weights = 0;
            for (std::size_t i = 0; i < scores.size(); ++i) {
                if (std::isnan(scores[i])) continue;
                const double x = first[i] - centre.x, y = second[i] - centre.y;
                const double weight = std::exp(-(x * x + y * y) / (2 * k_reach * k_reach));
                sum += weight * scores[i];
                weights += weight;
            }
            if (weights > 0) smooth.at(row, column) = sum / weights;
        }
    }
    return smooth;
}

bool draw_calibration_charts(const CalibrationInput& input, const CalibrationRuns& runs,
                             const CalibrationResult& result, const ResultDirectory& directory, RunLog& log) {
    const SceneSpec& scene = input.own.front().base.spec;
    if (scene.output.maps.front() == "off" || !scene.output.charts) return true;
    MapSource source;
    source.title = calibration_title(input);
    source.style = calibration_style(scene);
    directory.make_folder("charts");
    return draw_chart_rows(k_calibration_charts, CalibrationData{input, runs, result}, source, directory.folder(),
                           scene.output.report, log);
}

std::vector<ChartTitle> calibration_chart_titles() {
    return titles_of(k_calibration_charts);
}

}  // namespace frana::app::study
