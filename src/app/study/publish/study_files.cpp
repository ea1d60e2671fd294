// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/study_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "analysis/trace.h"
#include "app/input/check_inputs.h"
#include "app/pictures/charts.h"
#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/publish/publish_rasters.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/study/publish/hazard_curves.h"
#include "app/study/publish/map_writer.h"
#include "app/study/statistics/cell_statistics.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/text.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/used_keys.h"
#include "params/scene/write_scene.h"
#include "render/animation/movie.h"

namespace frana::app::study {
namespace {

constexpr std::size_t k_most_panels = 9;
constexpr const auto& k_colours = render::k_chart_colours;

/// What the charts of a study show.
struct ChartData {
    const StudyInput& input;
    const StudyResult& result;
    const std::vector<FigureSensitivity>& sensitivities;
};

std::string axis_label(const Figure& figure, const Words& words) {
    return with_unit(figure.title.in(words), figure.unit);
}

std::optional<render::Chart> exceedance(const ChartData& data, const std::string& title, const MapSource& source) {
    const StudyResult& result = data.result;
    if (result.figures().empty() || data.input.spec().region) return std::nullopt;
    const Words& words = source.style.words;
    render::Chart chart =
        chart_sheet(source, title, "", "members.csv", std::min(k_most_panels, result.figures().size()));
    for (std::size_t f = 0; f < result.figures().size() && chart.panels.size() < k_most_panels; ++f) {
        const Figure& figure = result.figures()[f];
        render::ChartPanel panel{
            figure.title.in(words), axis_label(figure, words), words("probability of more [-]"), {}, {0}};
        panel.series.push_back({"", k_colours[0], exceedance_curve(result.figure(f), result.finished.weights), 2.4});
        chart.panels.push_back(std::move(panel));
    }
    return chart;
}

/// One bar for each key, from 0 to its value, with its interval as a thin line.
std::optional<render::Chart> sensitivity(const ChartData& data, const std::string& title, const MapSource& source) {
    if (data.sensitivities.empty()) return std::nullopt;
    const Words& words = source.style.words;
    const bool by_indices =
        std::any_of(data.sensitivities.begin(), data.sensitivities.end(), [](const FigureSensitivity& figure) {
            return std::any_of(figure.keys.begin(), figure.keys.end(), [](const auto& one) { return one.total; });
        });
    const bool by_effects = data.sensitivities.front().keys.front().effect.has_value();
    render::Chart chart = chart_sheet(source, title,
                                      words(by_effects   ? worded("bar: mu* of Morris; line: 95 % interval")
                                            : by_indices ? worded("bar: total Sobol' index; circle: first order")
                                                         : worded("bar: rank correlation; line: 95 % interval")),
                                      "sensitivity.csv", std::min(k_most_panels, data.sensitivities.size()));
    for (const FigureSensitivity& figure : data.sensitivities) {
        if (chart.panels.size() == k_most_panels) break;
        render::ChartPanel panel{figure.figure.title.in(words),
                                 by_effects   ? axis_label(figure.figure, words)
                                 : by_indices ? words("fraction of the variance [-]")
                                              : "",
                                 "",
                                 {}};
        panel.note = words("the members do not tell it");
        const double count = static_cast<double>(figure.keys.size());
        panel.has_rows = true;
        panel.on_y = {0.5, count + 0.5};
        if (!by_effects) panel.on_x = {by_indices ? 0 : -1.05, 1.05};
        for (std::size_t k = 0; k < figure.keys.size(); ++k) {
            const KeySensitivity& one = figure.keys[k];
            std::optional<Interval> value = by_effects ? one.effect : one.rank_correlation;
            if (by_indices && !by_effects)
                value = one.total ? std::optional(Interval{*one.total, k_no_data, k_no_data}) : std::nullopt;
            if (!value) continue;
            const double y = count - static_cast<double>(k);
            const Rgb colour = k_colours[k % std::size(k_colours)];
            render::ChartSeries bar{title_in(data.input.table.keys[k], words), colour, {{0, y}, {value->value, y}}, 14};
            panel.series.push_back(std::move(bar));
            if (std::isfinite(value->low))
                panel.series.push_back({"", {20, 20, 20}, {{value->low, y}, {value->high, y}}, 1.6});
            if (by_effects || !by_indices) continue;
            render::ChartSeries first{"", {20, 20, 20}, {{*one.first_order, y}}, 1};
            first.marker = render::Marker::circle;
            panel.series.push_back(std::move(first));
        }
        chart.panels.push_back(std::move(panel));
    }
    return chart;
}

/// Of the gauges: solid the mean, dotted its fractiles.
std::optional<render::Chart> hazard_curve_chart(const ChartData& data, const std::string& title,
                                                const MapSource& source) {
    const Words& words = source.style.words;
    std::vector<render::ChartPanel> panels;
    const char* known = "";
    for (const HazardCurve& curve : hazard_curves(data.input, data.result, false)) {
        if (known != curve.quantity.key) {
            const ResultRaster& row = *find_result_raster(curve.quantity.raster);
            const std::string name = words(row.title);
            panels.push_back({name, with_unit(name, row.unit), with_unit(title, "1/a"), {}});
            panels.back().y = render::Scale::decades;
            known = curve.quantity.key;
        }
        std::vector<render::ChartSeries>& all = panels.back().series;
        const std::size_t number = all.size() / 3;
        for (double HazardPoint::*line : {&HazardPoint::rate, &HazardPoint::low, &HazardPoint::high}) {
            render::ChartSeries& series = all.emplace_back();
            for (const HazardPoint& point : curve.points) series.points.push_back({point.value, point.*line});
            render::look_apart(series, number);
            if (line == &HazardPoint::rate) {
                series.label = curve.place;
                continue;
            }
            series.stroke = render::Stroke::dotted;
            series.width_px = 1.2;
            series.marker.reset();
        }
    }
    if (panels.empty()) return std::nullopt;
    render::Chart chart = chart_sheet(source, title, "5 – 95 %", k_hazard_curves, panels.size());
    chart.panels = std::move(panels);
    return chart;
}

/// Every chart of a study, in the order of the page.
constexpr ChartRow<ChartData> k_charts[] = {
    {{"exceedance", worded("exceedance")}, exceedance},
    {{RasterName::sensitivity, worded("sensitivity of the results")}, sensitivity},
    {{"hazard_curves", worded("Annual rate")}, hazard_curve_chart},
};

}  // namespace

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

std::vector<ChartTitle> study_charts() {
    return titles_of(k_charts);
}

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
        input_.reading.study.region ? add_sources(rows) : add_probabilities(rows);
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

    const StudyInput& input_;
    const StudyResult& result_;
    const gis::FeatureLayer& layer_;
    std::vector<std::vector<std::size_t>> cells_;
    std::vector<ExposureValues> values_;
};

}  // namespace

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
    return totals;
}

namespace {

/// Of depth and velocity alone.
void write_quantiles(const StudyResult& result, const QuantityMaps& maps, Quantity quantity, const std::string& name,
                     const MapWriter& writer) {
    std::vector<std::optional<Raster>> upper;
    if (result.open.any()) upper = quantile_bounds(result.open, quantity, result.grid);
    for (std::size_t q = 0; q < maps.quantile.size(); ++q) {
        const std::string file = "quantile_max_" + name + "_" + k_study_quantiles[q].name;
        if (result.open.any())
            writer.write_quantile(file, maps.quantile[q], upper[q]);
        else
            writer.write(file, maps.quantile[q]);
    }
}

/// Of the cells with at least this probability.
PolygonFeature probability_outline(const Raster& probability, double least) {
    Raster mask(probability.grid);
    probability.values.for_each_stored([&](std::size_t cell, double value) {
        if (value >= least) mask.values[cell] = 1;
    });
    PolygonFeature feature;
    feature.parts = gis::polygonise(mask);
    feature.numbers["probability"] = least;
    return feature;
}

/// @param margins by which the probability may be greater (1), less (-1), or that do not count (0)
double area_at_least(const Raster& probability, double least, const Raster& margin, int margins = 0) {
    std::int64_t cells = 0;
    probability.values.for_each_stored(
        [&](std::size_t cell, double value) { cells += value > 0 && value + margins * margin.values[cell] >= least; });
    return static_cast<double>(cells) * probability.grid.cell_area();
}

Interval interval_at_least(const Raster& probability, double least, const Raster& margin) {
    return {area_at_least(probability, least, margin), area_at_least(probability, least, margin, -1),
            area_at_least(probability, least, margin, 1)};
}

/// extent.gpkg: as publish_ground writes it, with the outlines of the probability.
void write_probability_outlines(const StudyInput& input, const Raster& probability, const std::string& path) {
    std::vector<gis::OutlineLayer> layers = known_outlines(input);
    for (const StudyQuantile& quantile : k_study_quantiles) {
        gis::OutlineLayer layer{probability_layer(quantile.name), {}};
        PolygonFeature feature = probability_outline(probability, quantile.fraction);
        feature.numbers["threshold_m"] = input.base.spec.output.depth_thresholds.front();
        if (!feature.parts.empty()) layer.features.push_back(std::move(feature));
        layers.push_back(std::move(layer));
    }
    write_result_outlines(path, probability.grid.crs_wkt, layers, words_of(input.base.spec));
}

}  // namespace

std::vector<gis::OutlineLayer> known_outlines(const StudyInput& input) {
    gis::OutlineLayer release{"release", {}};
    const auto& areas = input.other_releases.empty() ? input.base.scene.release : input.other_releases;
    for (std::size_t i = 0; i < areas.size() && input.slopes.empty(); ++i)
        release.features.push_back(release_outline(areas[i], i));
    for (std::size_t i = 0; i < input.slopes.size(); ++i) {
        PolygonFeature feature;
        feature.parts = input.slopes[i].outline;
        feature.texts["name"] = input.slopes[i].name.empty() ? std::to_string(i) : input.slopes[i].name;
        release.features.push_back(std::move(feature));
    }
    std::vector<gis::OutlineLayer> layers{std::move(release)};
    if (input.base.scar) layers.push_back({"scar", input.base.scar->features});
    return layers;
}

void publish_study_ground(const StudyInput& input, const ResultDirectory& directory) {
    std::map<std::string, std::string> items;
    if (input.base.friction) {
        const ShownFriction shown = shown_friction(input);
        items = {{k_friction_of_item, shown.of}, {k_friction_varied_item, joined(shown.varied, ", ")}};
    }
    publish_ground(input.base, directory, items);
}

void publish_rates(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory,
                   StudyFacts& facts) {
    if (!result.rates) return;
    const MapWriter writer(input.base, directory);
    const std::vector<double> periods = input.spec().frequency.mapped_periods();
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        const RateMaps maps = writer.write_rates(result, events, periods);
        if (events.quantity != Quantity::depth || maps.rate.empty()) continue;
        facts.reached_threshold = events.thresholds.front();
        for (const double years : periods)
            facts.once_m2.push_back(
                interval_at_least(maps.rate.front(), (1 - k_weight_rounding) / years, maps.margin.front()));
    }
    if (const auto curves = hazard_curves(input, result, true); !curves.empty())
        write_text_file(directory.path(k_hazard_curves), hazard_curves_csv(curves));
    if (const std::string parts = disaggregation_csv(input, result); !parts.empty())
        write_text_file(directory.path(k_disaggregation), parts);
}

void publish_study_maps(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory,
                        StudyFacts& facts) {
    const OutputSpec& output = input.base.spec.output;
    const MapWriter writer(input.base, directory);
    const std::vector<float> none(result.finished.size());
    facts.least_margin = MeanEstimate(result.finished).probability(none, 0).margin;
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        const QuantityMaps maps = writer.write_probabilities(result.finished, result.open, result.grid, events);
        if (events.quantity == Quantity::depth) {
            write_quantiles(result, maps, events.quantity, "depth", writer);
            writer.write(RasterName::hit_count, maps.hits);
            if (!maps.probability.empty()) {
                write_probability_outlines(input, maps.probability.front(), directory.path(k_outlines_file));
                facts.reached_threshold = events.thresholds.front();
                if (input.base.friction && result.grid.same_cells(input.base.friction->terrain().grid))
                    facts.friction_areas = friction_areas(*input.base.friction, maps.probability.front());
                for (const StudyQuantile& quantile : k_study_quantiles)
                    facts.reached_m2.push_back(
                        area_at_least(maps.probability.front(), quantile.fraction, maps.margin.front()));
                facts.half_reached_m2 = interval_at_least(maps.probability.front(), 0.5, maps.margin.front());
            }
        }
        if (events.quantity == Quantity::velocity) write_quantiles(result, maps, events.quantity, "velocity", writer);
        facts.error.add(maps.errors);
    }
    const QuantityMaps arrival = quantity_maps(result.finished, Quantity::arrival, result.grid, {});
    for (std::size_t q = 0; q < arrival.quantile.size(); ++q)
        writer.write(std::string("quantile_arrival_time_") + k_study_quantiles[q].name, arrival.quantile[q]);
    if (!result.equal_weights() || result.design_at.size() < 2 || result.points.are_dependent) return;
    const double threshold = output.depth_thresholds.empty() ? 0 : output.depth_thresholds.front();
    const std::vector<Raster> fractions =
        outline_fractions(result.design, result.points, Quantity::depth, threshold, result.grid);
    for (std::size_t k = 0; k < fractions.size(); ++k)
        if (!is_field_of_error(input, k)) writer.write("sensitivity_" + input.table.keys[k], fractions[k]);
}

void write_member(const StudyInput& input, std::size_t member, const MemberRecord& record, const GridSpec& grid,
                  const ResultDirectory& directory, const std::string& folder) {
    const auto path = [&](const std::string& file) { return directory.path(folder) + "/" + file; };
    SceneSpec scene = input.member(member).scene;
    if (record.end.end > 0) scene.time.end = record.end.end;
    write_text_file(path(k_scene_file), echoed_scene(scene, directory.target() + "/" + folder));
    const std::pair<const char*, Quantity> k_maps[] = {{RasterName::max_depth, Quantity::depth},
                                                       {RasterName::max_velocity, Quantity::velocity},
                                                       {RasterName::arrival_time, Quantity::arrival}};
    for (const auto& [name, quantity] : k_maps) {
        if (record.runs.empty()) continue;
        const ResultRaster& row = *find_result_raster(name);
        gis::write_geotiff(path(std::string(name) + ".tif"), record.raster(quantity, grid),
                           {row.name, description_of(row, row.name, scene.output), row.unit, provenance(input.base)});
    }
}

void draw_study(const StudyInput& input, const StudyResult& result, const std::vector<FigureSensitivity>& figures,
                const ResultDirectory& directory, RunLog& log) {
    const OutputSpec& output = input.base.spec.output;
    if (output.maps.front() == "off") return;
    is_drawn("the pictures", log, [&] {
        const ResultReader written(directory.folder());
        MapSource source = written.map_source();
        source.title = output.title.value_or(scene_name(input.base.spec));  // the folder does not have its name yet
        LayerDrawer drawer(source);
        drawer.draw_at_next_scale([&](const Sentence& warning) { log.warn(warning); });
        if (output.report) {
            make_drawing_folder(written.path(k_page_folder));
            drawer.draw_for_page_too(written.path(k_page_folder));
        }
        make_drawing_folder(written.path("maps"));
        for (const std::string& name : written.drawable()) {
            if (const ResultRaster* const row = find_result_raster(name); row == nullptr || !row->with_study) continue;
            is_drawn("maps/" + name, log,
                     [&] { drawer.draw(written.map_layer(name), false, written.path("maps/" + name)); });
        }
        if (!output.charts || (input.spec().region && !result.rates)) return;  // of sources there is no distribution
        make_drawing_folder(written.path("charts"));
        draw_chart_rows(k_charts, ChartData{input, result, figures}, source, written.directory(), output.report, log);
    });
}

}  // namespace frana::app::study
