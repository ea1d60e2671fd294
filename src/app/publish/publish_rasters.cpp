// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_rasters.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/ground_statistics.h"
#include "analysis/trace.h"
#include "app/store/recorded_inputs.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "app/text/text_file.h"
#include "core/colour.h"
#include "core/json.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"
#include "params/keys/zone_keys.h"
#include "simulation/run_summary.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

void write(const ResultDirectory& directory, const ResultRaster& row, const Raster& raster,
           const std::vector<double>& classes, const std::map<std::string, std::string>& origin,
           const OutputSpec& output, const Words& words) {
    const std::string file = directory.path(row.name + ".tif");
    gis::write_geotiff(file, raster, {row.name, description_of(row, row.name, output), row.unit, origin});
    if (row.is_drawn())
        gis::write_styles(file, gis::class_stops(palette(row.palette), classes, row.unit, words), row.unit,
                          gis::StyleKind::classed, words(row.title));
    else  // elevations
        gis::write_style(file, gis::relief_style(row.name, words(row.title)));
}

Feature feature(MultiPolygon parts, double threshold) {
    Feature result;
    result.shape.areas = std::move(parts);
    if (threshold > 0) result.numbers["threshold_m"] = threshold;
    return result;
}

/// The mean thickness of a released area in both directions.
void add_thickness(const ReleaseArea& area, const ReleasedArea& released, const RunResult& result, Feature& outline) {
    if (!(released.area > 0)) return;
    const double vertical = released.volume / released.area;
    double normal = area.thickness * released.scaled;
    if (area.thickness_raster || !area.normal_to_bed) {
        double cosines = 0, cells = 0;
        gis::visit_cells(area.outline, result.raster(RasterName::bed).grid, gis::Cover::centres,
                         [&](std::int64_t row, std::int64_t column) {
                             if (!(result.raster("release").at(row, column) > 0)) return;
                             cosines += bed_cosine(result.raster(RasterName::bed), row, column);
                             cells += 1;
                         });
        normal = vertical * (cells > 0 ? cosines / cells : k_no_data);
    }
    outline.numbers["thickness_vertical_m"] = vertical;
    if (!std::isnan(normal)) outline.numbers["thickness_normal_m"] = normal;
}

/// Returns one layer with one feature, or an empty layer if there is no area to outline.
gis::ShapeLayer outline(const std::string& name, const Raster& depth, double threshold, const RunResult& result,
                        const Runout& run_out) {
    const Raster mask = trace_mask(depth, threshold);
    MultiPolygon parts = gis::polygonise(mask);
    if (parts.empty()) return {name, {}};
    Feature area = feature(std::move(parts), threshold);
    const Raster vertical = result.depth_is_normal ? vertical_depth(depth, result.raster(RasterName::bed)) : depth;
    double volume = 0;
    mask.values.for_each_stored([&](std::size_t cell, double inside) {
        if (inside != 0) volume += vertical.values[cell] * result.raster(RasterName::bed).grid.cell_area();
    });
    area.numbers["volume_m3"] = volume;
    const PeakValues high = high_values(depth, mask);
    area.numbers["max_depth_m"] = high.greatest;
    area.numbers["max_depth_p999_m"] = high.p999;
    area.numbers["runout_m"] = run_out.horizontal_m;
    area.numbers["drop_m"] = run_out.drop_m;
    area.numbers["reach_angle_deg"] = run_out.reach_angle_deg;
    return {name, {area}};
}

}  // namespace

Feature release_outline(const ReleaseArea& area, std::size_t index) {
    Feature outline = feature(area.outline, 0);
    outline.texts["name"] = area.name.empty() ? std::to_string(index + 1) : area.name;
    return outline;
}

std::map<std::string, std::string> result_tags(const Prepared& prepared, const RunResult& result) {
    std::map<std::string, std::string> tags = provenance(prepared);
    if (is_open(result, prepared.scene))
        tags[k_lower_bound_item] = "the full reach of the flow is not known, see warnings in summary.json";
    return tags;
}

void publish_rasters(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory) {
    const std::map<std::string, std::string> origin = result_tags(prepared, result);
    const ResultRaster& deepest = *find_result_raster(RasterName::max_depth);
    const std::vector<double> depths =
        class_bounds(deepest, result.raster(RasterName::max_depth), result.raster("release"));
    for (const ResultRaster& row : result_rasters())
        if (const Raster* raster = result.find_raster(row.name))
            write(directory, row, *raster, row.is_flow_depth ? depths : class_bounds(row, maximum(*raster)), origin,
                  prepared.spec.output, words_of(prepared.spec));
}

void publish_dtm(const Prepared& prepared, const ResultDirectory& directory,
                 const std::map<std::string, std::string>& friction_items) {
    std::map<std::string, std::string> origin = provenance(prepared);
    const auto write_one = [&](const std::string& name, const Raster& raster) {
        const ResultRaster& row = *find_result_raster(name);
        write(directory, row, raster, class_bounds(row, maximum(raster)), origin, prepared.spec.output,
              words_of(prepared.spec));
    };
    write_one(RasterName::dtm, prepared.scene.terrain);
    if (!prepared.friction) return;
    const FrictionTable& table = prepared.friction->choice().table;
    origin[k_friction_item] = table.called;
    origin[k_friction_source_item] = table.named_source;
    if (table.is_source_read()) origin[k_friction_read_item] = table.read_at;
    if (!table.texts.empty()) origin[k_scheme_words_item] = Json(table.texts).dump();
    for (const auto& [name, text] : friction_items) origin[name] = text;
    for (const ZoneKey& key : zone_keys())  // named as their columns
        if (find_result_raster(key.columns.back()) != nullptr)
            write_one(key.columns.back(), *(prepared.scene.zones.*raster_of(key)));
}

void publish_ground(const Prepared& prepared, const ResultDirectory& directory,
                    const std::map<std::string, std::string>& friction_items) {
    publish_dtm(prepared, directory, friction_items);
    gis::ShapeLayer release{"release", {}};
    for (std::size_t i = 0; i < prepared.scene.release.size(); ++i)
        release.features.push_back(release_outline(prepared.scene.release[i], i));
    std::vector<gis::ShapeLayer> layers{std::move(release)};
    if (prepared.scar) layers.push_back({"scar", prepared.scar->features});
    write_result_shapes(directory.path(k_outlines_file), prepared.scene.grid.crs_wkt, layers, words_of(prepared.spec));
    write_text_file(directory.path(k_scene_file), echoed_scene(prepared));
    write_text_file(directory.path(k_inputs_file), recorded_inputs(prepared));
}

void publish_outlines(const Prepared& prepared, const RunResult& result, const SeparateFlows& flows,
                      const Runout& run_out, const ResultDirectory& directory) {
    std::vector<gis::ShapeLayer> layers{{"release", {}}};
    for (std::size_t i = 0; i < prepared.scene.release.size(); ++i) {
        const ReleaseArea& area = prepared.scene.release[i];
        const ReleasedArea& released = result.released[i];
        Feature release = release_outline(area, i);
        add_thickness(area, released, result, release);
        release.numbers["volume_m3"] = released.volume;
        release.numbers["start_s"] = released.start;
        layers[0].features.push_back(std::move(release));
    }
    const double threshold = prepared.spec.output.trace_threshold;
    layers.push_back(outline("trace", result.raster(RasterName::max_depth), threshold, result, run_out));
    const Raster deposit = trace_mask(result.raster(RasterName::final_depth), threshold);
    layers.push_back(
        outline("deposit", result.raster(RasterName::final_depth), threshold, result,
                runouts(flows, result.raster(RasterName::bed), result.raster("release"), deposit).front()));
    for (Feature& trace : layers[1].features) {
        // The volume over the trace is that released; depths at different times do not add up.
        trace.numbers["volume_m3"] = result.volume_initial;
        const PeakValues speed = high_values(result.raster(RasterName::max_velocity),
                                             trace_mask(result.raster(RasterName::max_depth), threshold));
        trace.numbers["max_velocity_ms"] = speed.greatest;
        trace.numbers["max_velocity_p999_ms"] = speed.p999;
    }
    if (is_open(result, prepared.scene))
        for (const std::size_t layer : {1, 2})
            for (Feature& reached : layers[layer].features) reached.numbers[k_lower_bound_column] = 1;
    if (prepared.scar) layers.push_back({"scar", prepared.scar->features});
    write_result_shapes(directory.path(k_outlines_file), prepared.scene.grid.crs_wkt, layers, words_of(prepared.spec));
}

}  // namespace frana::app
