// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_study.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "analysis/hazard.h"
#include "app/input/check_inputs.h"
#include "app/pictures/map_layer.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/publish_rasters.h"
#include "app/store/vector_layers.h"
#include "app/study/publish/hazard_curves.h"
#include "app/study/publish/map_writer.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {
namespace {

using Values = std::span<const float>;

/// The quantity of records that breaks features.
Quantity quantity_of(const BreakingQuantity& by) {
    const auto found = std::find_if(std::begin(k_curve_quantities), std::end(k_curve_quantities),
                                    [&](const CurveQuantity& one) { return one.key == std::string(by.column); });
    return found->quantity;
}

class Builder {
  public:
    Builder(const StudyInput& input, const StudyResult& result)
        : input_(input),
          result_(result),
          layer_(*input.base.extra.exposure),
          cells_(exposed_cells(layer_, result.grid)),
          values_(layer_.features.size()) {
        const Raster& terrain = input.base.scene.terrain;
        const bool is_known = input.slopes.empty() && !terrain.values.is_tiled();
        for (std::size_t f = 0; f < cells_.size() && is_known; ++f)
            values_[f].has_ground =
                cells_[f].empty() || std::any_of(cells_[f].begin(), cells_[f].end(),
                                                 [&](std::size_t cell) { return !std::isnan(terrain.values[cell]); });
    }

    std::vector<ExposureRow> rows(const Bounds& map) {
        greatest(Quantity::depth, &ExposureValues::depth);
        greatest(Quantity::velocity, &ExposureValues::velocity);
        greatest(Quantity::pressure, &ExposureValues::pressure);
        if (uses_momentum()) greatest(Quantity::momentum, &ExposureValues::momentum);
        for_each(Quantity::arrival, [&](std::size_t feature, Values values) {
            const float first = *std::min_element(values.begin(), values.end());
            if (std::isfinite(first)) values_[feature].arrival = static_cast<double>(first);
        });
        std::vector<ExposureRow> rows = exposure_rows(layer_, values_, map);
        input_.spec().region ? add_sources(rows) : add_probabilities(rows);
        if (input_.spec().region && input_.spec().region->has_scenarios()) add_scenarios(rows);
        if (result_.rates) add_rates(rows);
        if (input_.base.extra.fragility) add_damage(rows);
        return rows;
    }

    std::vector<DamageSum> damages;  ///< of all rows

  private:
    [[nodiscard]] bool uses_momentum() const {
        const auto& fragility = input_.base.extra.fragility;
        return fragility && fragility->uses(HazardQuantity::momentum);
    }
    /// Of all runs: one that failed has hit before it failed.
    template <class Visit>
    void for_each(Quantity quantity, const Visit& visit) const {
        for_each_feature(result_, quantity, result_.grid, cells_,
                         [&](std::size_t feature, Values, Values all) { visit(feature, all); });
    }
    [[nodiscard]] std::size_t source_of(std::size_t run) const {
        return result_.members[run].member / input_.table.draws;
    }
    void greatest(Quantity quantity, double ExposureValues::*member) {
        for_each(quantity, [&](std::size_t feature, Values values) {
            values_[feature].*member = static_cast<double>(*std::max_element(values.begin(), values.end()));
        });
    }
    void add_probabilities(std::vector<ExposureRow>& rows) const {
        const MeanEstimate estimate(result_.finished);
        const auto add = [&](Quantity quantity, const std::vector<double>& thresholds,
                             const std::vector<std::string>& names) {
            const auto set = [&](std::size_t feature, const std::string& name, double value) {
                rows[feature].numbers.emplace_back(name, rows[feature].is_on_map() ? value : k_no_data);
            };
            for_each_feature(result_, quantity, result_.grid, cells_,
                             [&](std::size_t feature, Values values, Values all) {
                                 for (std::size_t t = 0; t < thresholds.size(); ++t)
                                     set(feature, names[t], estimate.probability(values, thresholds[t]).value);
                                 for (std::size_t t = 0; t < thresholds.size() && result_.any_open(); ++t)
                                     set(feature, names[t] + "_upper", upper_bound(result_, all, thresholds[t]));
                             });
        };
        add(Quantity::depth, {0}, {"probability_reached"});
        for (const MappedEvents& events : mapped_events(input_.base.spec))
            add(events.quantity, events.thresholds, events.rasters);
    }
    void add_rates(std::vector<ExposureRow>& rows) const {
        const auto add = [&](Quantity quantity, double threshold, const std::string& name) {
            for_each_feature(result_, quantity, result_.grid, cells_, [&](std::size_t f, Values values, Values all) {
                const HazardPoint point = hazard_point(result_, values, all, threshold);
                for (const auto& [ending, value] :
                     {std::pair("", point.rate), std::pair("_low", point.low), std::pair("_high", point.high)})
                    rows[f].numbers.emplace_back(name + ending, rows[f].is_on_map() ? value : k_no_data);
            });
        };
        add(Quantity::depth, 0, "annual_rate_reached");
        for (const MappedEvents& events : mapped_events(input_.base.spec))
            for (std::size_t t = 0; t < events.thresholds.size(); ++t)
                add(events.quantity, events.thresholds[t], rate_name(events.rasters[t]));
    }
    void add_sources(std::vector<ExposureRow>& rows) const {
        for_each(Quantity::depth, [&](std::size_t feature, Values values) {
            ExposureRow& row = rows[feature];
            const auto worst =
                static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
            const std::size_t source = source_of(worst);
            const auto count = [&](const auto& counts) {
                std::set<std::size_t> sources;
                for (std::size_t record = 0; record < values.size(); ++record)
                    if (counts(record)) sources.insert(source_of(record));
                return row.is_on_map() ? static_cast<double>(sources.size()) : k_no_data;
            };
            row.numbers.emplace_back("sources", count([&](std::size_t record) { return values[record] > 0; }));
            if (result_.any_open())  // those whose full reach is not known may have come, too
                row.numbers.emplace_back("sources_upper", count([&](std::size_t record) {
                                             return values[record] > 0 || result_.is_open[record];
                                         }));
            row.numbers.emplace_back("worst_source", row.is_reached() ? static_cast<double>(source) : k_no_data);
            row.texts.emplace_back("worst_name", row.is_reached() ? input_.slopes[source].name : "");
        });
    }

    /// The greatest value of a feature in each scenario: "T30_max_depth_m".
    void add_scenarios(std::vector<ExposureRow>& rows) const {
        const std::vector<Scenario> scenarios = scenarios_of(input_);
        std::vector<std::pair<Quantity, std::string>> columns;
        if (hazard_scheme_of(input_.base.spec)) columns.emplace_back(Quantity::intensity, "intensity");
        for (const CurveQuantity& one : k_curve_quantities)
            if (one.quantity != Quantity::momentum || uses_momentum()) columns.emplace_back(one.quantity, one.key);
        for (const auto& [quantity, column] : columns)
            for_each(quantity, [&, name = column](std::size_t feature, Values values) {
                std::map<std::string, double> greatest;
                for (std::size_t record = 0; record < values.size(); ++record) {
                    double& most = greatest[input_.slopes[source_of(record)].scenario];
                    most = std::max(most, static_cast<double>(values[record]));
                }
                for (const Scenario& one : scenarios)
                    rows[feature].numbers.emplace_back(one.stem + "_" + name,
                                                       rows[feature].is_on_map() ? greatest[one.name] : k_no_data);
            });
        if (input_.spec().region->degrees) add_degree(rows);
    }

    void add_damage(std::vector<ExposureRow>& rows) {
        const Fragility& fragility = *input_.base.extra.fragility;
        if (result_.rates || !input_.spec().region) return add_mean_damage(fragility, rows);
        if (!input_.spec().region->has_scenarios())
            damages.push_back(add_event_damage(fragility, "", "", result_.any_open(), rows));
        else
            for (const Scenario& one : scenarios_of(input_)) {
                bool is_open = false;
                for (std::size_t run = 0; run < result_.members.size(); ++run)
                    is_open = is_open || (result_.is_open[run] &&
                                          input_.slope_of(result_.members[run].member).scenario == one.name);
                damages.push_back(add_event_damage(fragility, one.stem + "_", one.name, is_open, rows));
            }
    }

    /// Of many runs: the mean damage of an event or, with a frequency, that of a year; in sum with an interval of its
    /// own, as features are hit together.
    void add_mean_damage(const Fragility& fragility, std::vector<ExposureRow>& rows) {
        std::vector<Damage> all(rows.size());
        double most = 0;
        for (std::size_t f = 0; f < rows.size(); ++f) most += rows[f].is_on_map() ? fragility.most(f) : 0;
        const auto mean_of = [&](const std::vector<double>& runs, double greatest) {
            std::vector<double> finished;
            for (const std::size_t run : result_.finished_at) finished.push_back(runs[run]);
            return mean_damage(result_, finished, runs, greatest);
        };
        std::vector<double> own(result_.members.size()), sum(result_.members.size());
        for (const BreakingQuantity& by : k_breaking_quantities)
            if (fragility.uses(by.quantity))
                for_each(quantity_of(by), [&](std::size_t f, Values values) {
                    if (fragility.of(f).by != &by) return;
                    for (std::size_t m = 0; m < own.size(); ++m) {
                        own[m] = fragility.damage(f, static_cast<double>(values[m]));
                        if (rows[f].is_on_map()) sum[m] += own[m];
                    }
                    all[f] = mean_of(own, fragility.most(f));
                });
        damages.push_back(add_damages(result_.rates ? k_annual_damage : k_expected_damage, "", all, rows));
        damages.back().damage = mean_of(sum, most);
    }

    /// The degree of hazard of a feature, the scenarios that lead to it, and of the slopes that do the deepest.
    void add_degree(std::vector<ExposureRow>& rows) const {
        const DegreeMatrix& degrees = *input_.spec().region->degrees;
        std::vector<std::vector<float>> depths(rows.size());
        for_each(Quantity::depth,
                 [&](std::size_t feature, Values values) { depths[feature].assign(values.begin(), values.end()); });
        for_each(Quantity::intensity, [&](std::size_t feature, Values values) {
            int degree = 0, most = 0;
            std::set<std::size_t> by;  // slopes
            std::size_t deepest = 0;
            for (std::size_t record = 0; record < values.size(); ++record) {
                const auto& period = input_.slopes[source_of(record)].return_period;
                if (!period) continue;
                const auto of = [&](int intensity) { return static_cast<int>(degrees.of(intensity, *period)); };
                const int own = values[record] >= 1 ? of(static_cast<int>(values[record])) : 0;
                if (result_.any_open() && result_.is_open[record]) most = std::max(most, of(k_strongest));
                if (own == 0 || own < degree) continue;
                if (own > degree) by.clear();
                if (by.empty() || depths[feature][record] > depths[feature][deepest]) deepest = record;
                degree = own;
                by.insert(source_of(record));
            }
            ExposureRow& row = rows[feature];
            const bool has_one = row.is_on_map() && degree > 0;
            std::vector<std::string> scenarios;  // all that lead to it
            for (const Scenario& one : scenarios_of(input_))
                if (std::any_of(by.begin(), by.end(),
                                [&](std::size_t slope) { return input_.slopes[slope].scenario == one.name; }))
                    scenarios.push_back(one.name);
            row.numbers.emplace_back(RasterName::hazard_degree, row.is_on_map() ? degree : k_no_data);
            if (result_.any_open())
                row.numbers.emplace_back(std::string(RasterName::hazard_degree) + "_upper",
                                         row.is_on_map() ? std::max(degree, most) : k_no_data);
            row.texts.emplace_back("degree_scenario", has_one ? joined(scenarios, ", ") : "");
            row.texts.emplace_back("degree_source", has_one ? input_.slopes[source_of(deepest)].name : "");
        });
    }

    static constexpr int k_strongest = 3;  ///< class of intensity of a degree's matrix

    const StudyInput& input_;
    const StudyResult& result_;
    const gis::FeatureLayer& layer_;
    std::vector<std::vector<std::size_t>> cells_;
    std::vector<ExposureValues> values_;
};

/// What the report shows of each feature besides the greatest values: the classes of each scenario and the degree, or
/// the rates.
std::vector<std::pair<std::string, std::vector<std::string>>> shown_columns(const StudyInput& input,
                                                                            const StudyResult& result) {
    const Words words = words_of(input.base.spec);
    std::vector<std::pair<std::string, std::vector<std::string>>> all;
    const auto scheme = hazard_scheme_of(input.base.spec);
    if (input.spec().region && input.spec().region->has_scenarios())
        for (const Scenario& one : scenarios_of(input)) {
            std::vector<std::string> titles, names;
            if (scheme) {
                titles.push_back(words(scheme->heading));
                names.push_back(one.stem + "_intensity");
            }
            for (const auto& [raster, column] : {std::pair{RasterName::max_depth, "_max_depth_m"},
                                                 {RasterName::max_velocity, "_max_velocity_ms"},
                                                 {RasterName::max_pressure, "_max_pressure_kpa"}}) {
                titles.push_back(find_result_raster(raster)->unit);
                names.push_back(one.stem + column);
            }
            all.emplace_back(one.name + ": " + joined(titles, "; "), names);
        }
    if (input.spec().region && input.spec().region->degrees)
        all.emplace_back(words("Degree of hazard"),
                         std::vector<std::string>{RasterName::hazard_degree, "degree_scenario", "degree_source"});
    if (!result.rates) return all;
    for (const MappedEvents& events : mapped_events(input.base.spec))
        for (const std::string& raster :
             events.quantity == Quantity::depth ? events.rasters : std::vector<std::string>{}) {
            const std::string name = rate_name(raster);
            const ResultRaster& row = *find_result_raster(name);
            all.emplace_back(with_unit(raster_title(row, name, words), row.unit), std::vector{name});
        }
    return all;
}

}  // namespace

std::vector<Scenario> scenarios_of(const StudyInput& input) {
    std::map<std::string, double> periods;
    for (const Slope& slope : input.slopes)  // of one without a period, whose column is wrong, another slope says it
        if (!slope.scenario.empty())
            periods[slope.scenario] = std::max(periods[slope.scenario], slope.return_period.value_or(0));
    std::vector<Scenario> scenarios;
    for (const auto& [name, period] : periods) scenarios.push_back({name, "", period});
    std::sort(scenarios.begin(), scenarios.end(), [](const Scenario& a, const Scenario& b) {
        return a.return_period != b.return_period ? a.return_period < b.return_period : precedes(a.name, b.name);
    });
    std::vector<std::string> names;
    for (const Scenario& one : scenarios) names.push_back(one.name);
    const std::vector<std::string> stems = file_stems(names);
    for (std::size_t i = 0; i < stems.size(); ++i) scenarios[i].stem = stems[i];
    return scenarios;
}

std::optional<ExposureTotals> publish_study_exposure(const StudyInput& input, const StudyResult& result,
                                                     const Bounds& map, const ResultDirectory& directory) {
    const auto& layer = input.base.extra.exposure;
    if (!layer) return std::nullopt;
    const Words words = words_of(input.base.spec);
    Builder builder(input, result);
    ExposureTotals totals = write_exposure(*layer, builder.rows(map), result.grid.crs_wkt, words, directory);
    totals.is_least = result.any_open();
    totals.more_columns = shown_columns(input, result);
    totals.damages = std::move(builder.damages);
    for (const DamageSum& one : totals.damages)
        totals.more_columns.emplace_back(one.title(words), std::vector{one.name});
    return totals;
}

}  // namespace frana::app::study
