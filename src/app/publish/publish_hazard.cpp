// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_hazard.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/hazard.h"
#include "app/pictures/map_layer.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "core/json.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "gis/vector/vector_out.h"
#include "params/keys/output_parameters.h"
#include "simulation/run_summary.h"

namespace frana::app {
namespace {

constexpr const char* k_hazard = "hazard";  // the raster's row

Raster mask_of(const Raster& classes, int value) {
    Raster mask(classes.grid);
    classes.values.for_each_stored([&](std::size_t cell, double kind) {
        if (kind == value) mask.values[cell] = 1;
    });
    return mask;
}

std::vector<gis::ColourStop> stops_of(const ClassMap& map, const Words& words) {
    std::vector<gis::ColourStop> stops;
    for (const HazardClass& kind : map.classes)
        stops.push_back(
            {static_cast<double>(kind.value), kind.colour, class_label(kind.label(), words), false, kind.hatched});
    return stops;
}

std::string titled(const ClassMap& map, const Words& words) {
    const std::string title = words(map.title) + ", " + map.scheme.name;
    return map.limits.empty() ? title : title + "; " + class_label(map.limits.front(), words);
}

void write_raster(const Raster& classes, const ClassMap& map, const std::string& path, const Words& words,
                  std::map<std::string, std::string> metadata) {
    std::vector<gis::ClassEntry> entries;
    for (const HazardClass& kind : map.classes)
        entries.push_back({static_cast<std::uint8_t>(kind.value), kind.label(), kind.colour});
    metadata["HAZARD_TITLE"] = map.title;
    metadata[k_scheme_item] = map.scheme.name;
    metadata[k_scheme_title_item] = map.scheme.called;
    if (!map.scheme.texts.empty()) metadata[k_scheme_words_item] = Json(map.scheme.texts).dump();
    metadata["HAZARD_SOURCE"] = map.source;
    for (std::size_t i = 0; i < map.limits.size(); ++i) metadata[k_limit_item + std::to_string(i + 1)] = map.limits[i];
    gis::write_class_geotiff(path, classes, entries, {map.name, map.title + " after " + map.scheme.name, "", metadata});
    gis::write_styles(path, stops_of(map, words), "", gis::StyleKind::exact, titled(map, words));
}

std::vector<HazardArea> write_zones(const Raster& classes, const ClassMap& map, const std::string& path,
                                    bool is_lower_bound, const Words& words) {
    gis::OutlineLayer zones{std::filesystem::path(path).stem().string(), {}};
    std::vector<HazardArea> areas;
    for (const HazardClass& kind : map.classes) {
        PolygonFeature feature;
        feature.parts = gis::polygonise(mask_of(classes, kind.value));
        areas.push_back({kind, area(feature.parts)});
        if (feature.parts.empty()) continue;
        feature.numbers["class"] = kind.value;
        if (is_lower_bound) feature.numbers[k_lower_bound_column] = 1;
        feature.texts = {{"label", kind.label()},
                         {"name", kind.name},
                         {"thresholds", kind.thresholds},
                         {"scheme", map.scheme.name},
                         {"source", map.source}};
        zones.features.push_back(std::move(feature));
    }
    zones.style = gis::titled(gis::polygon_style(zones.name, titled(map, words), "class", stops_of(map, words)),
                              titled(map, words), attribute_titles(words));
    gis::write_outlines(path, classes.grid.crs_wkt, {zones});
    gis::write_style(path, zones.style);
    return areas;
}

}  // namespace

std::optional<HazardScheme> hazard_scheme_of(const SceneSpec& scene) {
    std::optional<HazardScheme> scheme = scene.hazard.resolved;
    if (scheme) scheme->minimum_depth = hazard_minimum_depth(scene);
    return scheme;
}

std::vector<std::string> intensity_limits(const HazardScheme& scheme) {
    std::vector<std::string> lines = scheme.minimum_labels();
    for (const HazardClass& kind : scheme.classes) lines.push_back(intensity_name(kind.value) + ": " + kind.thresholds);
    if (!scheme.is_source_read()) lines.push_back(scheme.source);
    return lines;
}

std::vector<HazardArea> publish_classes(const Raster& classes, const ClassMap& map,
                                        const std::map<std::string, std::string>& metadata, const Words& words,
                                        const ResultDirectory& directory) {
    write_raster(classes, map, directory.path(map.name + ".tif"), words, metadata);
    if (map.zones_file.empty()) return {};
    return write_zones(classes, map, directory.path(map.zones_file), metadata.contains(k_lower_bound_item), words);
}

std::vector<HazardArea> publish_hazard(const Prepared& prepared, const RunResult& result,
                                       const ResultDirectory& directory) {
    const std::optional<HazardScheme> scheme = hazard_scheme_of(prepared.spec);
    if (!scheme) return {};
    const Raster classes = intensity_classes(result, *scheme);
    const ClassMap map{k_hazard,       scheme->heading,     scheme->classes,         *scheme,
                       scheme->source, k_hazard_zones_file, scheme->minimum_labels()};
    return publish_classes(classes, map, result_tags(prepared, result), words_of(prepared.spec), directory);
}

}  // namespace frana::app
