// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_hazard.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "analysis/hazard.h"
#include "app/pictures/map_layer.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "core/json.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "gis/vector/generalise.h"
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

/// The attributes of a class, perhaps in a language.
std::map<std::string, std::string> attributes_of(const HazardClass& kind, const ClassMap& map, const Words* words) {
    const auto in = [&](const std::string& text) { return words != nullptr ? class_label(text, *words) : text; };
    return {{"label", in(kind.label())},
            {"name", in(kind.name)},
            {"thresholds", in(kind.thresholds)},
            {"scheme", map.scheme.name},
            {"source", in(map.source)}};
}

gis::ShapeLayer class_layer(const std::string& name, const ClassMap& map, const Words& words) {
    gis::ShapeLayer layer{name, {}};
    layer.style = gis::titled(gis::polygon_style(name, titled(map, words), "class", stops_of(map, words)),
                              titled(map, words), attribute_titles(words));
    return layer;
}

/// The zones of each class that has some.
std::vector<gis::Zone> generalised_zones(const Raster& classes, const ClassMap& map, const Words& words,
                                         std::vector<HazardArea>& areas) {
    std::vector<MultiPolygon> at_least;
    for (const HazardClass& kind : map.classes) {
        Raster mask(classes.grid);
        classes.values.for_each_stored([&](std::size_t cell, double value) {
            if (value >= kind.value) mask.values[cell] = 1;
        });
        at_least.push_back(gis::polygonise(mask));
    }
    // Steps of cells along a slanting edge go.
    const double tolerance = classes.grid.cell_size / std::numbers::sqrt2;
    auto zones = gis::generalised(at_least, {map.scheme.least_area, map.scheme.least_width, tolerance});
    if (zones.empty())  // as the cells have them
        for (const HazardClass& kind : map.classes) zones.push_back(gis::polygonise(mask_of(classes, kind.value)));
    std::vector<gis::Zone> all;
    for (std::size_t k = 0; k < zones.size(); ++k) {
        const HazardClass& kind = map.classes[k];
        areas[k].zones_m2 = area(zones[k]);
        for (const Polygon& part : zones[k]) {
            gis::Zone& zone = all.emplace_back(gis::Zone{{}, words(kind.name), kind.colour});
            zone.feature.shape.areas = {part};
            zone.feature.texts = attributes_of(kind, map, &words);
            zone.feature.numbers = {
                {"class", kind.value}, {"cells_m2", areas[k].area_m2}, {"zones_m2", areas[k].zones_m2}};
        }
    }
    return all;
}

std::vector<HazardArea> write_zones(const Raster& classes, const ClassMap& map, const std::string& file,
                                    bool is_lower_bound, const SceneSpec& spec, const ResultDirectory& directory) {
    const Words words = words_of(spec);
    const std::string path = directory.path(file), stem = std::filesystem::path(file).stem().string();
    gis::ShapeLayer own = class_layer(stem, map, words), drawn = class_layer(k_generalised_layer, map, words);
    std::vector<HazardArea> areas;
    for (const HazardClass& kind : map.classes) {
        Feature feature;
        feature.shape.areas = gis::polygonise(mask_of(classes, kind.value));
        areas.push_back({kind, area(feature.shape.areas)});
        if (feature.shape.areas.empty()) continue;
        feature.numbers["class"] = kind.value;
        if (is_lower_bound) feature.numbers[k_lower_bound_column] = 1;
        feature.texts = attributes_of(kind, map, nullptr);
        own.features.push_back(std::move(feature));
    }
    std::vector<gis::Zone> zones = generalised_zones(classes, map, words, areas);
    for (gis::Zone& zone : zones) {
        if (is_lower_bound) zone.feature.numbers[k_lower_bound_column] = 1;
        drawn.features.push_back(zone.feature);
    }
    gis::write_shapes(path, classes.grid.crs_wkt, {own, drawn});
    gis::write_style(path, own.style);
    for (const char* format : k_zone_formats)
        if (has_format(spec.output, format))
            gis::write_zones(directory.path(stem + "." + format), classes.grid.crs_wkt, zones);
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
                                        const std::map<std::string, std::string>& metadata, const SceneSpec& spec,
                                        const ResultDirectory& directory) {
    write_raster(classes, map, directory.path(map.name + ".tif"), words_of(spec), metadata);
    return write_zones(classes, map, map.zones_file, metadata.contains(k_lower_bound_item), spec, directory);
}

std::vector<HazardArea> publish_hazard(const Prepared& prepared, const RunResult& result,
                                       const ResultDirectory& directory) {
    const std::optional<HazardScheme> scheme = hazard_scheme_of(prepared.spec);
    if (!scheme) return {};
    const Raster classes = intensity_classes(result, *scheme);
    const ClassMap map{k_hazard,       scheme->heading,     scheme->classes,         *scheme,
                       scheme->source, k_hazard_zones_file, scheme->minimum_labels()};
    return publish_classes(classes, map, result_tags(prepared, result), prepared.spec, directory);
}

}  // namespace frana::app
