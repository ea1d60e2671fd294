// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_files.h"

#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include "analysis/trace.h"
#include "app/ensemble/map_writer.h"
#include "app/ensemble/mapped_events.h"
#include "app/ensemble/study_charts.h"
#include "app/input/scene_language.h"
#include "app/pictures/charts.h"
#include "app/pictures/class_words.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/publish/publish_rasters.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/store/saved_work.h"
#include "app/store/vector_layers.h"
#include "app/text/text_file.h"
#include "core/shortest_text.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/rasterize.h"
#include "params/keys/result_rasters.h"
#include "params/scene/write_scene.h"
#include "render/canvas/drawing_modules.h"

namespace frana::app {
namespace {

/// Quantiles and moments, of depth and velocity alone.
void write_distribution(const StudyResult& result, const study::QuantityMaps& maps, study::Quantity quantity,
                        const std::string& name, const MapWriter& writer) {
    const bool is_open = result.open_weight > 0;
    const auto upper = is_open ? study::upper_quantiles(result.closed, result.open_weight, quantity, result.grid)
                               : std::vector<std::optional<Raster>>{};
    for (std::size_t q = 0; q < maps.quantile.size(); ++q) {
        const std::string file = "quantile_max_" + name + "_" + k_study_quantiles[q].name;
        if (is_open)
            writer.write_quantile(file, maps.quantile[q], upper[q]);
        else
            writer.write(file, maps.quantile[q]);
    }
    writer.write("mean_max_" + name, maps.mean);
    writer.write("deviation_max_" + name, maps.deviation);
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

double area_at_least(const Raster& probability, double least) {
    std::int64_t cells = 0;
    probability.values.for_each_stored([&](std::size_t, double value) { cells += value >= least; });
    return static_cast<double>(cells) * probability.grid.cell_area();
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

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + error.message(), folder, "", "",
                                                    "Check the place's rights and free space"});
}

/// Those that are handed on; `frana render` draws the others.
bool is_drawn_at_once(const std::string& name) {
    return name.starts_with("probability_") || name.starts_with("quantile_max_depth_") ||
           name.starts_with("sensitivity_") || name.starts_with("union_max_") || name == "hit_count" ||
           name.starts_with("scenario_max_depth_") || name.starts_with("scenario_intensity_") ||
           name == "hazard_degree";
}

/// The runs that were cut, left the ground or failed. None of a multilevel study: its weights have either sign.
std::vector<study::OpenRun> open_runs(const StudyInput& input, const StudyResult& result, const std::string& folder) {
    std::vector<study::OpenRun> open;
    if (!input.levels.empty()) return open;
    double sum = 0;
    for (const MemberResult& one : result.members) sum += input.table.weights[one.member];
    for (const MemberResult& one : result.members)
        if (one.end.is_open() || !one.failure.empty())
            open.push_back(
                {record_file(folder, one.member), input.table.weights[one.member] / sum, one.failure.empty()});
    return open;
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
    publish_ground(input.base, directory);
}

void publish_study_maps(const StudyInput& input, const StudyResult& result, const ResultDirectory& directory,
                        StudyFacts& facts) {
    const OutputSpec& output = input.base.spec.output;
    const MapWriter writer(input.base, directory);
    const std::vector<study::OpenRun> open = open_runs(input, result, directory.folder());
    std::vector<Raster> errors;
    for (const MappedEvents& events : mapped_events(input.base.spec)) {
        study::QuantityMaps maps =
            study::quantity_maps(result.finished, events.quantity, result.grid, events.thresholds);
        const std::vector<Raster> upper =
            open.empty() ? std::vector<Raster>{}
                         : study::upper_bounds(maps.probability, open, events.quantity, events.thresholds, result.grid);
        for (std::size_t t = 0; t < events.rasters.size(); ++t)
            writer.write_probability(events.rasters[t], maps.probability[t], maps.error[t],
                                     open.empty() ? nullptr : &upper[t]);
        if (events.quantity == study::Quantity::depth) {
            write_distribution(result, maps, events.quantity, "depth", writer);
            writer.write("hit_count", maps.hits);
            if (!maps.probability.empty()) {
                write_probability_outlines(input, maps.probability.front(), directory.path(k_outlines_file));
                facts.reached_threshold = events.thresholds.front();
                for (const StudyQuantile& quantile : k_study_quantiles)
                    facts.reached_m2.push_back(area_at_least(maps.probability.front(), quantile.fraction));
            }
        }
        if (events.quantity == study::Quantity::velocity)
            write_distribution(result, maps, events.quantity, "velocity", writer);
        std::move(maps.error.begin(), maps.error.end(), std::back_inserter(errors));
    }
    const study::QuantityMaps arrival =
        study::quantity_maps(result.finished, study::Quantity::arrival, result.grid, {});
    for (std::size_t q = 0; q < arrival.quantile.size(); ++q)
        writer.write(std::string("quantile_arrival_time_") + k_study_quantiles[q].name, arrival.quantile[q]);
    if (result.equal_weights() && result.design_at.size() > 1) {
        const double threshold = output.depth_thresholds.empty() ? 0 : output.depth_thresholds.front();
        const std::vector<Raster> maps =
            study::sensitivity_maps(result.design, result.points, result.groups, result.grid, threshold);
        for (std::size_t k = 0; k < maps.size(); ++k) writer.write("sensitivity_" + input.table.keys[k], maps[k]);
    }
    facts.error = study::map_error(errors);
}

void write_member(const StudyInput& input, std::size_t member, const study::MemberRecord& record, const GridSpec& grid,
                  const ResultDirectory& directory, const std::string& folder) {
    const auto path = [&](const std::string& file) { return directory.path(folder) + "/" + file; };
    SceneSpec scene = input.member(member).scene;
    if (!input.slopes.empty() && !record.figures.empty()) scene.terrain.bounds = record.grid().bounds();
    write_text_file(path(k_scene_file), echoed_scene(scene, directory.target() + "/" + folder));
    const std::pair<const char*, study::Quantity> k_maps[] = {{"max_depth", study::Quantity::depth},
                                                              {"max_velocity", study::Quantity::velocity},
                                                              {"arrival_time", study::Quantity::arrival}};
    for (const auto& [name, quantity] : k_maps) {
        if (record.runs.empty()) continue;
        const ResultRaster& row = *find_result_raster(name);
        gis::write_geotiff(path(std::string(name) + ".tif"), record.raster(quantity, grid),
                           {row.name, description_of(row, row.name, scene.output), row.unit, provenance(input.base)});
    }
}

void load_study_drawing(const StudyInput& input) {
    const OutputSpec& output = input.base.spec.output;
    const bool films = output.animation && !input.reading.study.per_polygon();
    if (films || output.maps.front() != "off") render::vtk();
    if (films) render::libav();
}

bool draw_study(const StudyInput& input, const StudyResult& result, const std::vector<FigureSensitivity>& figures,
                const ResultDirectory& directory, RunLog& log) {
    const OutputSpec& output = input.base.spec.output;
    if (output.maps.front() == "off") return true;
    bool good = true;
    const ResultReader written(directory.folder());
    MapSource source = written.map_source();
    source.title = output.title.value_or(scene_name(input.base.spec));  // the folder does not have its name yet
    const auto attempt = [&](const std::string& what, const auto& draw) {
        try {
            draw();
            log.note("drew " + what);
        } catch (const Error& error) {
            log.warn(worded("{1} could not be drawn: {2}", {what, std::string(error.what())}));
            good = false;
        }
    };
    LayerDrawer drawer(source);
    drawer.draw_at_next_scale([&](const Sentence& warning) { log.warn(warning); });
    if (output.report) {
        make_folder(written.path(k_page_folder));
        drawer.draw_for_page_too(written.path(k_page_folder));
    }
    make_folder(written.path("maps"));
    for (const std::string& name : written.drawable()) {
        if (!is_drawn_at_once(name)) continue;
        attempt("maps/" + name, [&] { drawer.draw(written.map_layer(name), false, written.path("maps/" + name)); });
    }
    if (!output.charts || input.reading.study.per_polygon()) return good;  // of sources there is no distribution
    make_folder(written.path("charts"));
    for (const NamedChart& one : study_charts(input, result, figures, convergence_of(input, result), source)) {
        attempt("charts/" + one.name, [&] { write_chart(one, source.style, written.directory(), output.report); });
    }
    return good;
}

}  // namespace frana::app
