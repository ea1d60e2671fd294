// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/study_exposure.h"

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
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/study/publish/hazard_curves.h"
#include "app/study/publish/map_writer.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/text.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {
namespace {

using Values = std::span<const float>;

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
        for_each(Quantity::arrival, [&](std::size_t feature, Values values) {
            const float first = *std::min_element(values.begin(), values.end());
            if (std::isfinite(first)) values_[feature].arrival = static_cast<double>(first);
        });
        std::vector<ExposureRow> rows = exposure_rows(layer_, values_, map);
        input_.spec().region ? add_sources(rows) : add_probabilities(rows);
        if (input_.spec().region && input_.spec().region->scenario) add_scenarios(rows);
        if (result_.rates) add_rates(rows);
        return rows;
    }

  private:
    /// Of all runs whose records count: one that failed has hit before it failed.
    template <class Visit>
    void for_each(Quantity quantity, const Visit& visit) const {
        const bool has_open = result_.open.any();
        for_each_feature(has_open ? result_.open.runs : result_.finished, quantity, result_.grid, cells_, visit);
    }
    [[nodiscard]] std::size_t source_of(std::size_t record) const {
        const std::size_t place = result_.open.any() ? record : result_.finished_at[record];
        return result_.members[place].member / input_.table.draws;
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
            for_each_feature(result_.finished, quantity, result_.grid, cells_, [&](std::size_t feature, Values values) {
                for (std::size_t t = 0; t < thresholds.size(); ++t)
                    set(feature, names[t], estimate.probability(values, thresholds[t]).value);
            });
            if (!result_.open.any()) return;
            for_each(quantity, [&](std::size_t feature, Values values) {
                for (std::size_t t = 0; t < thresholds.size(); ++t)
                    set(feature, names[t] + "_upper", upper_bound(result_.open, values, thresholds[t]));
            });
        };
        add(Quantity::depth, {0}, {"probability_reached"});
        for (const MappedEvents& events : mapped_events(input_.base.spec))
            add(events.quantity, events.thresholds, events.rasters);
    }
    void add_rates(std::vector<ExposureRow>& rows) const {
        const auto add = [&](Quantity quantity, double threshold, const std::string& name) {
            std::vector<HazardPoint> points(rows.size());
            for_each_feature(result_.finished, quantity, result_.grid, cells_, [&](std::size_t feature, Values values) {
                points[feature] = hazard_point(*result_.rates, values, threshold);
            });
            if (result_.open.any())
                for_each(quantity, [&](std::size_t feature, Values runs) {
                    points[feature].high =
                        std::max(points[feature].high, hazard_bound(*result_.rates, runs, threshold));
                });
            for (std::size_t f = 0; f < rows.size(); ++f)
                for (const auto& [ending, value] : {std::pair("", points[f].rate), std::pair("_low", points[f].low),
                                                    std::pair("_high", points[f].high)})
                    rows[f].numbers.emplace_back(name + ending, rows[f].is_on_map() ? value : k_no_data);
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
            if (result_.open.any())  // those whose full reach is not known may have come, too
                row.numbers.emplace_back("sources_upper", count([&](std::size_t record) {
                                             return values[record] > 0 || result_.open.is_open[record];
                                         }));
            row.numbers.emplace_back("worst_source", row.is_reached() ? static_cast<double>(source) : k_no_data);
            row.texts.emplace_back("worst_name", row.is_reached() ? input_.slopes[source].name : "");
        });
    }

    /// The greatest value of a feature in each scenario: "T30_max_depth_m".
    void add_scenarios(std::vector<ExposureRow>& rows) const {
        const std::vector<Scenario> scenarios = scenarios_of(input_);
        constexpr std::pair<Quantity, const char*> k_columns[] = {{Quantity::intensity, "intensity"},
                                                                  {Quantity::depth, "max_depth_m"},
                                                                  {Quantity::velocity, "max_velocity_ms"},
                                                                  {Quantity::pressure, "max_pressure_kpa"}};
        const bool has_classes = hazard_scheme_of(input_.base.spec).has_value();
        for (const auto& [quantity, column] : k_columns) {
            if (quantity == Quantity::intensity && !has_classes) continue;
            for_each(quantity, [&, name = std::string(column)](std::size_t feature, Values values) {
                std::map<std::string, double> greatest;
                for (std::size_t record = 0; record < values.size(); ++record) {
                    double& most = greatest[input_.slopes[source_of(record)].scenario];
                    most = std::max(most, static_cast<double>(values[record]));
                }
                for (const Scenario& one : scenarios)
                    rows[feature].numbers.emplace_back(one.stem + "_" + name,
                                                       rows[feature].is_on_map() ? greatest[one.name] : k_no_data);
            });
        }
        if (input_.spec().region->return_period && has_classes) add_degree(rows);
    }

    /// The degree of hazard of a feature, and the scenario and slope that decide it: of several the deepest.
    void add_degree(std::vector<ExposureRow>& rows) const {
        const DegreeMatrix& degrees = input_.spec().region->degrees;
        std::vector<std::vector<float>> depths(rows.size());
        for_each(Quantity::depth,
                 [&](std::size_t feature, Values values) { depths[feature].assign(values.begin(), values.end()); });
        for_each(Quantity::intensity, [&](std::size_t feature, Values values) {
            int degree = 0, most = 0;
            std::size_t by = 0;
            for (std::size_t record = 0; record < values.size(); ++record) {
                const auto& period = input_.slopes[source_of(record)].return_period;
                if (!period) continue;
                const auto of = [&](int intensity) { return static_cast<int>(degrees.of(intensity, *period)); };
                const int own = values[record] >= 1 ? of(static_cast<int>(values[record])) : 0;
                if (result_.open.any() && result_.open.is_open[record]) most = std::max(most, of(k_strongest));
                if (own < degree || (own == degree && !(depths[feature][record] > depths[feature][by]))) continue;
                degree = own;
                by = record;
            }
            ExposureRow& row = rows[feature];
            const Slope& slope = input_.slopes[source_of(by)];
            const bool has_one = row.is_on_map() && degree > 0;
            row.numbers.emplace_back(RasterName::hazard_degree, row.is_on_map() ? degree : k_no_data);
            if (result_.open.any())
                row.numbers.emplace_back(std::string(RasterName::hazard_degree) + "_upper",
                                         row.is_on_map() ? std::max(degree, most) : k_no_data);
            row.texts.emplace_back("degree_scenario", has_one ? slope.scenario : "");
            row.texts.emplace_back("degree_source", has_one ? slope.name : "");
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
std::vector<std::pair<std::string, std::string>> shown_columns(const StudyInput& input, const StudyResult& result) {
    const Words words = words_of(input.base.spec);
    std::vector<std::pair<std::string, std::string>> all;
    const auto scheme = hazard_scheme_of(input.base.spec);
    if (input.spec().region && input.spec().region->scenario && scheme)
        for (const Scenario& one : scenarios_of(input))
            all.emplace_back(one.name + ": " + words(scheme->heading), one.stem + "_intensity");
    if (input.spec().region && input.spec().region->return_period)
        all.emplace_back(words("Degree of hazard"), RasterName::hazard_degree);
    if (!result.rates) return all;
    for (const MappedEvents& events : mapped_events(input.base.spec))
        for (const std::string& raster :
             events.quantity == Quantity::depth ? events.rasters : std::vector<std::string>{}) {
            const std::string name = rate_name(raster);
            const ResultRaster& row = *find_result_raster(name);
            all.emplace_back(with_unit(raster_title(row, name, words), row.unit), name);
        }
    return all;
}

}  // namespace

std::vector<Scenario> scenarios_of(const StudyInput& input) {
    std::map<std::pair<double, std::string>, bool> all;
    for (const Slope& slope : input.slopes)
        if (!slope.scenario.empty()) all[{slope.return_period.value_or(0), slope.scenario}] = true;
    std::vector<std::string> names;
    for (const auto& [order, present] : all) names.push_back(order.second);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const std::vector<std::string> stems = file_stems(names);
    std::vector<Scenario> scenarios;
    for (std::size_t i = 0; i < names.size(); ++i) scenarios.push_back({names[i], stems[i]});
    return scenarios;
}

void warn_of_unknown_exposure(const StudyInput& input, RunLog& log) {
    if (const auto& exposed = input.base.extra.exposure)
        app::warn_of_unknown_exposure(*exposed, input.base.scene.grid.bounds(),
                                      input.reading.study.region ? nullptr : &input.base.scene.terrain, log);
}

ReachedBy exposure_reached_by(const StudyInput& input) {
    return input.reading.study.region ? ReachedBy::any_slope : ReachedBy::any_run;
}

std::optional<ExposureTotals> publish_study_exposure(const StudyInput& input, const StudyResult& result,
                                                     const Bounds& map, const ResultDirectory& directory) {
    const auto& layer = input.base.extra.exposure;
    if (!layer) return std::nullopt;
    ExposureTotals totals = write_exposure(*layer, Builder(input, result).rows(map), result.grid.crs_wkt,
                                           words_of(input.base.spec), directory);
    totals.is_least = result.open.any();
    totals.more_columns = shown_columns(input, result);
    return totals;
}

}  // namespace frana::app::study
