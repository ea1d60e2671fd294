// SPDX-License-Identifier: Apache-2.0
#include "app/publish_rasters.h"

#include "analysis/trace.h"
#include "app/layers.h"
#include "app/version.h"
#include "core/colour.h"
#include "core/json.h"
#include "gis/raster_out.h"
#include "gis/rasterize.h"
#include "gis/styles.h"
#include "gis/vector_out.h"

namespace frana::app {
namespace {

void write(const ResultDirectory& directory, const std::string& name, const Raster& raster,
           const std::string& description, const std::string& unit, const SceneSpec& spec) {
    gis::write_geotiff(directory.path(name + ".tif"), raster,
                       {name,
                        description,
                        unit,
                        {{"PROGRAM", k_program}, {"VERSION", k_version}, {"SCENE", scene_name(spec)}}});
}

PolygonFeature feature(MultiPolygon parts, double threshold) {
    PolygonFeature result;
    result.parts = std::move(parts);
    if (threshold > 0) result.numbers["threshold_m"] = threshold;
    return result;
}

/// One layer with one feature, or an empty layer where there is no ground to outline.
gis::OutlineLayer outline(const std::string& name, const Raster& depth, double threshold) {
    MultiPolygon parts = gis::polygonise(trace_mask(depth, threshold));
    if (parts.empty()) return {name, {}};
    return {name, {feature(std::move(parts), threshold)}};
}

void publish_exchange(const SceneSpec& spec, const RunResult& result, const ResultDirectory& directory) {
    const auto publish = [&](const std::string& name, const Raster& depth, const std::string& description) {
        write(directory, name, depth, description, "m", spec);
        gis::write_styles(directory.path(name + ".tif"),
                          gis::class_stops(palette("depth"),
                                           layer_classes(layer_named("final_depth"), maximum(depth)), "m"),
                          "m", gis::StyleKind::classed);
    };
    publish("eroded_depth", result.eroded_depth, "Depth eroded from the bed, vertical");
    publish("deposited_depth", result.deposited_depth, "Depth deposited on the bed, vertical");
}

}  // namespace

void publish_rasters(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory) {
    for (const Layer& layer : result_layers()) {
        const Raster& raster = result.*layer.values;
        write(directory, layer.name, raster, layer.description, layer.unit, prepared.spec);
        gis::write_styles(
            directory.path(layer.name + ".tif"),
            gis::class_stops(palette(layer.palette), layer_classes(layer, maximum(raster)), layer.unit),
            layer.unit, gis::StyleKind::classed);
    }
    if (result.exchanges) publish_exchange(prepared.spec, result, directory);
    write(directory, "dtm", prepared.scene.terrain, "Terrain on the working grid", "m", prepared.spec);
    write(directory, "bed", result.bed, "Bed that was slid over", "m", prepared.spec);
    write(directory, "release", result.release, "Thickness released, vertical", "m", prepared.spec);
    gis::write_styles(directory.path("release.tif"),
                      gis::class_stops(palette("depth"),
                                       layer_classes(layer_named("max_depth"), maximum(result.release)), "m"),
                      "m", gis::StyleKind::classed);
}

void publish_outlines(const Prepared& prepared, const RunResult& result, const ResultDirectory& directory) {
    std::vector<gis::OutlineLayer> layers{{"release", {}}};
    for (const ReleaseArea& area : prepared.scene.release) {
        PolygonFeature release = feature(area.outline, 0);
        if (!area.thickness_raster) release.numbers["thickness_m"] = area.thickness;
        layers[0].features.push_back(std::move(release));
    }
    const double threshold = prepared.spec.output.trace_threshold;
    layers.push_back(outline("trace", result.max_depth, threshold));
    layers.push_back(outline("deposit", result.final_depth, threshold));
    if (prepared.scar) layers.push_back({"scar", prepared.scar->features});
    gis::write_outlines(directory.path("extent.gpkg"), prepared.scene.grid.crs_wkt, layers);
}

}  // namespace frana::app
