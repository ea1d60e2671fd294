// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/publish_study.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "analysis/trace.h"
#include "app/input/check_inputs.h"
#include "app/pictures/charts.h"
#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/publish/map_page.h"
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
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/used_keys.h"
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
        panel.note = words("no estimate");
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
            // Below a tenth of the least rate a fractile is next to never, and would make the axis of it.
            double least = std::numeric_limits<double>::infinity();
            for (const HazardPoint& point : curve.points)
                if (point.rate > 0) least = std::min(least, 0.1 * point.rate);
            for (const HazardPoint& point : curve.points)
                series.points.push_back({point.value, point.*line < least ? k_no_data : point.*line});
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

/// Of depth and velocity alone.
void write_quantiles(const QuantityMaps& maps, const std::string& name, const MapWriter& writer) {
    for (std::size_t q = 0; q < maps.quantile.size(); ++q) {
        const std::string file = "quantile_max_" + name + "_" + k_study_quantiles[q].name;
        if (maps.quantile_upper.empty())
            writer.write(file, maps.quantile[q]);
        else
            writer.write_quantile(file, maps.quantile[q], maps.quantile_upper[q]);
    }
}

/// Of the cells with at least this probability.
Feature probability_outline(const Raster& probability, double least) {
    Raster mask(probability.grid);
    probability.values.for_each_stored([&](std::size_t cell, double value) {
        if (value >= least) mask.values[cell] = 1;
    });
    Feature feature;
    feature.shape.areas = gis::polygonise(mask);
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
    std::vector<gis::ShapeLayer> layers = known_outlines(input);
    for (const StudyQuantile& quantile : k_study_quantiles) {
        gis::ShapeLayer layer{probability_layer(quantile.name), {}};
        Feature feature = probability_outline(probability, quantile.fraction);
        feature.numbers["threshold_m"] = input.base.spec.output.depth_thresholds.front();
        if (!feature.shape.areas.empty()) layer.features.push_back(std::move(feature));
        layers.push_back(std::move(layer));
    }
    write_result_shapes(path, probability.grid.crs_wkt, layers, words_of(input.base.spec));
}

}  // namespace

std::vector<gis::ShapeLayer> known_outlines(const StudyInput& input) {
    gis::ShapeLayer release{"release", {}};
    const auto& areas = input.other_releases.empty() ? input.base.scene.release : input.other_releases;
    for (std::size_t i = 0; i < areas.size() && input.slopes.empty(); ++i)
        release.features.push_back(release_outline(areas[i], i));
    for (std::size_t i = 0; i < input.slopes.size(); ++i) {
        Feature feature;
        feature.shape.areas = input.slopes[i].outline;
        feature.texts["name"] = input.slopes[i].name.empty() ? std::to_string(i) : input.slopes[i].name;
        release.features.push_back(std::move(feature));
    }
    std::vector<gis::ShapeLayer> layers{std::move(release)};
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
        for (const double years : periods) {
            const double once = (1 - k_weight_rounding) / years;
            Interval& area =
                facts.once_m2.emplace_back(interval_at_least(maps.rate.front(), once, maps.margin.front()));
            // Open runs may reach every cell as often: then nobody knows how large the area is.
            if (result.rates->has_open())
                area.high = result.rates->bound({}, 0) >= once
                                ? k_no_data
                                : std::max(area.high, area_at_least(maps.upper.front(), once, maps.margin.front(), 0));
        }
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
        const QuantityMaps maps = writer.write_probabilities(result, result.grid, events);
        if (events.quantity == Quantity::depth) {
            write_quantiles(maps, "depth", writer);
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
        if (events.quantity == Quantity::velocity) write_quantiles(maps, "velocity", writer);
        facts.error.add(maps.errors);
    }
    const QuantityMaps arrival = quantity_maps(result, Quantity::arrival, result.grid, {});
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
                const ResultDirectory& directory, Findings found) {
    const OutputSpec& output = input.base.spec.output;
    if (output.maps.front() == "off" && !output.report) return;
    is_drawn("the pictures", found, [&] {
        const ResultReader written(directory.folder());
        MapSource source = written.map_source();
        source.title = output.title.value_or(scene_name(input.base.spec));  // the folder does not have its name yet
        if (output.report) is_drawn(k_map_page_file, found, [&] { write_map_page(written, source); });
        if (output.maps.front() == "off") return;
        LayerDrawer drawer(source);
        drawer.draw_at_next_scale([&](const Sentence& warning) { found.warn(warning); });
        if (output.report) {
            make_drawing_folder(written.path(k_page_folder));
            drawer.draw_for_page_too(written.path(k_page_folder));
        }
        make_drawing_folder(written.path("maps"));
        for (const std::string& name : written.drawable()) {
            if (const ResultRaster* const row = find_result_raster(name); row == nullptr || !row->with_study) continue;
            is_drawn("maps/" + name, found,
                     [&] { drawer.draw(written.map_layer(name), false, written.path("maps/" + name)); });
        }
        const bool has_curves = result.rates && !input.base.scene.recording.gauges.empty();
        if (!output.charts || (input.spec().region && !has_curves)) return;  // of sources there is no distribution
        make_drawing_folder(written.path("charts"));
        draw_chart_rows(k_charts, ChartData{input, result, figures}, source, written.directory(), output.report, found);
    });
}

}  // namespace frana::app::study
