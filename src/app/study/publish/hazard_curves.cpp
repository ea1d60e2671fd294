// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/hazard_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

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

/// Fractiles of 5, 50 and 95 % of a gamma distribution.
std::array<double, 3> fractiles(double mean, double deviation) {
    constexpr double k_certain = 1e-6;
    if (!(deviation > k_certain * mean)) return {mean, mean, mean};
    std::vector<double> all = openturns().quantiles({Law::gamma, {mean, deviation}, {}, {}, {}}, {0.05, 0.5, 0.95});
    constexpr double k_never = 1e-9;  // a year: rarer than anybody can tell
    for (double& one : all) one = one < k_never ? 0 : one;
    return {all[0], all[1], all[2]};
}

using Values = std::span<const float>;

/// Of the values of all members those that came.
std::vector<CellStore::Value> hits_of(Values values) {
    std::vector<CellStore::Value> hits;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] > 0) hits.push_back({static_cast<std::uint32_t>(i), values[i]});
    return hits;
}

/// The row of a quantity that has hazard curves; null: it has none.
const CurveQuantity* curve_quantity(Quantity quantity) {
    const auto found = std::find_if(std::begin(k_curve_quantities), std::end(k_curve_quantities),
                                    [&](const CurveQuantity& one) { return one.quantity == quantity; });
    return found == std::end(k_curve_quantities) ? nullptr : found;
}

std::vector<std::vector<std::size_t>> cells_of(const std::vector<CurvePlace>& places) {
    std::vector<std::vector<std::size_t>> cells;
    for (const CurvePlace& place : places) cells.push_back(place.cells);
    return cells;
}

/// The upper fractile of a sum of rates that nobody knows better than the rates of the sources.
double highest(const AnnualRates& rates, double sum) {
    const FrequencySpec::Rate all = rates.of_all();
    return fractiles(sum, sum * all.deviation / all.value).back();
}

/// @param most of an event: no event is not among all
HazardPoint point_of(const AnnualRates& rates, const AnnualRate& rate, double most) {
    const FrequencySpec::Rate all = rates.of_all();
    const double greatest = most * fractiles(all.value, all.deviation).back();
    if (!(rate.value > 0)) return {0, 0, 0, std::min(rate.margin, greatest)};
    const auto [low, median, high] = fractiles(rate.value, rate.margin / k_normal);
    return {0, rate.value, low, std::min(high, greatest), std::min(median, greatest)};
}

}  // namespace

HazardPoint hazard_point(const StudyResult& result, Values values, Values runs, double threshold) {
    const AnnualRates& rates = *result.rates;
    HazardPoint point = point_of(rates, rates.exceeded(hits_of(values), threshold), 1);
    point.value = threshold;
    if (result.any_open()) point.high = std::max(point.high, highest(rates, rates.bound(hits_of(runs), threshold)));
    return point;
}

Damage mean_damage(const StudyResult& result, std::span<const double> damages, std::span<const double> runs,
                   double most) {
    const bool has_open = result.any_open();
    if (const auto& rates = result.rates) {
        const HazardPoint sum = point_of(*rates, rates->sum(damages, most), most);
        const double bound = has_open ? highest(*rates, rates->bound_of_sum(runs, most)) : 0;
        return {sum.rate, sum.low, std::max(sum.high, bound)};
    }
    const Estimate mean = MeanEstimate(result.finished).mean(damages, most);
    const std::vector<double> greatest = result.at_most(runs, most);
    const double bound =
        has_open ? std::inner_product(greatest.begin(), greatest.end(), result.all.weights.begin(), 0.0) : 0;
    return {mean.value, std::max(0.0, mean.value - mean.margin),
            std::max(std::min(most, mean.value + mean.margin), bound)};
}

std::vector<HazardCurve> hazard_curves(const StudyInput& input, const StudyResult& result, bool with_objects) {
    std::vector<HazardCurve> curves;
    const std::vector<CurvePlace> places = curve_places(input, result, with_objects);
    if (!result.rates || places.empty()) return curves;
    const std::vector<std::vector<std::size_t>> cells = cells_of(places);
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        const CurveQuantity* const quantity = curve_quantity(events.quantity);
        if (quantity == nullptr) continue;
        const std::size_t first = curves.size();
        for (const CurvePlace& place : places) curves.push_back({place.kind, place.name, *quantity, {}});
        for_each_feature(result, events.quantity, result.grid, cells, [&](std::size_t at, Values values, Values runs) {
            const double greatest = static_cast<double>(*std::max_element(values.begin(), values.end()));
            for (const double level : curve_levels(greatest, events.thresholds))
                curves[first + at].points.push_back(hazard_point(result, values, runs, level));
        });
    }
    for (HazardCurve& curve : curves)  // what exceeds a value exceeds all lower ones
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
            std::vector<HazardPoint>& points = curve.points;
            points[i].high = std::min(points[i].high, points[i - 1].high);
            points[points.size() - 1 - i].low =
                std::max(points[points.size() - 1 - i].low, points[points.size() - i].low);
        }
    return curves;
}

std::string disaggregation_csv(const StudyInput& input, const StudyResult& result) {
    std::vector<std::string> columns{"kind", "place",       "quantity", "value",    "source",
                                     "name", "annual_rate", "fraction", "volume_m3"};
    const SampleTable& members = input.table;
    std::vector<std::size_t> keys;  // that have a mean
    for (std::size_t k = 0; k < members.keys.size(); ++k)
        if (!members.nominal[k] && members.keys[k] != k_volume_key) keys.push_back(k);
    for (const std::size_t key : keys) columns.push_back(members.keys[key]);
    Table table(columns);
    const std::vector<CurvePlace> places = curve_places(input, result, true);
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        const CurveQuantity* const quantity = curve_quantity(events.quantity);
        if (quantity == nullptr) continue;
        for_each_feature(
            result, events.quantity, result.grid, cells_of(places), [&](std::size_t at, Values values, Values) {
                for (const double threshold : events.thresholds) {
                    const std::vector<double> of_sources = result.rates->by_source(hits_of(values), threshold);
                    const double all = std::accumulate(of_sources.begin(), of_sources.end(), 0.0);
                    for (std::size_t i = 0; i < of_sources.size(); ++i) {
                        if (!(of_sources[i] > 0)) continue;
                        const Source& source = result.rates->sources()[i];
                        std::vector<Cell> row{places[at].kind,
                                              places[at].name,
                                              quantity->key,
                                              shortest_text(threshold),
                                              std::to_string(i),
                                              source.name,
                                              shortest_text(of_sources[i]),
                                              shortest_text(of_sources[i] / all)};
                        const auto mean = [&](const auto& value_of_member) {
                            FinishedMembers some;
                            std::vector<double> own;
                            for (std::size_t m = 0; m < source.members.size(); ++m) {
                                if (!(static_cast<double>(values[source.first + m]) > threshold)) continue;
                                some.weights.push_back(source.members.weights[m]);
                                own.push_back(value_of_member(result.members[result.finished_at[source.first + m]]));
                            }
                            row.emplace_back(shortest_text(MeanEstimate(some).mean(own).value));
                        };
                        mean([](const MemberRecord& member) { return value_of(member.figures, "volume_m3"); });
                        for (const std::size_t key : keys)
                            mean([&](const MemberRecord& member) { return members.numbers[member.member][key]; });
                        table.row(row);
                    }
                }
            });
    }
    return table.rows().empty() ? "" : table.csv();
}

std::string hazard_curves_csv(const std::vector<HazardCurve>& curves) {
    Table table({"kind", "place", "quantity", "value", "annual_rate", "low", "high", "median"});
    for (const HazardCurve& curve : curves)
        for (const HazardPoint& point : curve.points)
            table.row({curve.kind, curve.place, curve.quantity.key, shortest_text(point.value),
                       shortest_text(point.rate), shortest_text(point.low), shortest_text(point.high),
                       shortest_text(point.median)});
    return table.csv();
}

}  // namespace frana::app::study
