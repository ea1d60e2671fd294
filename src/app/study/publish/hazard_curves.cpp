// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/hazard_curves.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "analysis/separate_flows.h"
#include "app/publish/publish_exposure.h"
#include "app/study/openturns/functions.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/text/text_table.h"
#include "params/grammar/value_text.h"

namespace frana::app::study {
namespace {

/// A place with its cells on the maps.
struct CurvePlace {
    std::string kind, name;
    std::vector<std::size_t> cells;
};

std::vector<CurvePlace> curve_places(const StudyInput& input, const StudyResult& result, bool with_objects) {
    std::vector<CurvePlace> all;
    for (const Gauge& gauge : input.base.scene.recording.gauges) {
        const auto cell = cell_at(result.grid, gauge.place);  // none: nothing came so far
        all.push_back({"gauge", gauge.name, cell ? std::vector{*cell} : std::vector<std::size_t>{}});
    }
    if (const auto& layer = input.base.extra.exposure; layer && with_objects) {
        const std::vector<std::vector<std::size_t>> cells = exposed_cells(*layer, result.grid);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!cells[i].empty()) all.push_back({"object", layer->features[i].name, cells[i]});
        }
    }
    return all;
}

/// 0, the thresholds, and 1, 1.5, 2, 3, 5, 7, 10 ... from 0.1 to the first above the greatest value.
std::vector<double> curve_levels(double greatest, const std::vector<double>& thresholds) {
    constexpr double k_steps[] = {1, 1.5, 2, 3, 5, 7};
    std::set<double> all{0};
    for (const double threshold : thresholds)
        if (threshold <= greatest) all.insert(threshold);
    for (int decade = -1; *all.rbegin() <= greatest; ++decade)
        for (const double step : k_steps)
            if (*all.rbegin() <= greatest) all.insert(decade < 0 ? step / 10 : step * std::pow(10, decade));
    return {all.begin(), all.end()};
}

/// Fractiles of 5 and 95 % of a gamma distribution.
std::pair<double, double> fractiles(double mean, double deviation) {
    constexpr double k_certain = 1e-6;
    if (!(deviation > k_certain * mean)) return {mean, mean};
    const std::vector<double> both = openturns().quantiles({Law::gamma, {mean, deviation}, {}, {}, {}}, {0.05, 0.95});
    return {both[0], both[1]};
}

HazardPoint point_of(const FrequencySpec::Rate& rate, double value, const Estimate& probability) {
    const double p = probability.value, e = probability.margin / k_normal;
    if (!(p > 0)) return {value, 0, 0, fractiles(rate.value, rate.deviation).second * probability.margin};
    const auto [low, high] =
        fractiles(rate.value * p, std::hypot(rate.value * e, rate.deviation * p, rate.deviation * e));
    return {value, rate.value * p, low, high};
}

}  // namespace

std::vector<HazardCurve> hazard_curves(const StudyInput& input, const StudyResult& result, bool with_objects) {
    std::vector<HazardCurve> curves;
    const auto& rate = input.spec().frequency.rate;
    const std::vector<CurvePlace> places = curve_places(input, result, with_objects);
    if (!rate || places.empty()) return curves;
    std::vector<std::vector<std::size_t>> cells;
    for (const CurvePlace& place : places) cells.push_back(place.cells);
    const MeanEstimate estimate(result.finished);
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        const auto quantity = std::find_if(std::begin(k_hazard_quantities), std::end(k_hazard_quantities),
                                           [&](const HazardQuantity& one) { return one.quantity == events.quantity; });
        if (quantity == std::end(k_hazard_quantities)) continue;
        const std::size_t first = curves.size();
        for (const CurvePlace& place : places) curves.push_back({place.kind, place.name, *quantity, {}});
        using Values = std::span<const float>;
        for_each_feature(result.finished, events.quantity, result.grid, cells, [&](std::size_t at, Values values) {
            const double greatest = static_cast<double>(*std::max_element(values.begin(), values.end()));
            for (const double level : curve_levels(greatest, events.thresholds))
                curves[first + at].points.push_back(point_of(*rate, level, estimate.probability(values, level)));
        });
        const double most = fractiles(rate->value, rate->deviation).second;
        const auto add_bound = [&](std::size_t at, Values values) {
            for (HazardPoint& point : curves[first + at].points)
                point.high = std::max(point.high, most * upper_bound(result.open, values, point.value));
        };
        if (result.open.any()) for_each_feature(result.open.runs, events.quantity, result.grid, cells, add_bound);
    }
    for (HazardCurve& curve : curves)  // what exceeds a value exceeds all lower ones
        for (std::size_t i = 1; i < curve.points.size(); ++i)
            curve.points[i].high = std::min(curve.points[i].high, curve.points[i - 1].high);
    return curves;
}

std::string hazard_curves_csv(const std::vector<HazardCurve>& curves) {
    Table table({"kind", "place", "quantity", "value", "annual_rate", "low", "high"});
    for (const HazardCurve& curve : curves)
        for (const HazardPoint& point : curve.points)
            table.row({curve.kind, curve.place, curve.quantity.key, shortest_text(point.value),
                       shortest_text(point.rate), shortest_text(point.low), shortest_text(point.high)});
    return table.csv();
}

}  // namespace frana::app::study
