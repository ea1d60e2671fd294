// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_hazard.h"

#include "app/input/scene_language.h"
#include "app/pictures/class_words.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/rasterize.h"
#include "gis/raster/styles.h"
#include "gis/vector/vector_out.h"
#include "simulation/run_intensity.h"

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

void write_raster(const Raster& classes, const HazardScheme& scheme, const std::string& path, const Words& words,
                  std::map<std::string, std::string> metadata) {
    std::vector<gis::ClassEntry> entries;
    std::vector<gis::ColourStop> stops;
    for (const HazardClass& kind : scheme.classes) {
        entries.push_back({static_cast<std::uint8_t>(kind.value), kind.label(), kind.colour});
        stops.push_back({static_cast<double>(kind.value), kind.colour, class_label(kind.label(), words)});
    }
    metadata["HAZARD_SCHEME"] = scheme.name;
    metadata["HAZARD_SOURCE"] = scheme.source;
    gis::write_class_geotiff(path, classes, entries,
                             {k_hazard, "Intensity after " + scheme.name, "", std::move(metadata)});
    gis::write_styles(path, stops, "", gis::StyleKind::exact,
                      words("{1}, scheme {2}", {words("Intensity"), scheme.name}));
}

std::vector<HazardArea> write_zones(const Raster& classes, const HazardScheme& scheme, const std::string& path,
                                    const std::string& crs_wkt, const Words& words) {
    gis::OutlineLayer zones{"hazard_zones", {}};
    std::vector<gis::ColourStop> stops;
    std::vector<HazardArea> areas;
    for (const HazardClass& kind : scheme.classes) {
        stops.push_back({static_cast<double>(kind.value), kind.colour, class_label(kind.label(), words)});
        PolygonFeature feature;
        feature.parts = gis::polygonise(mask_of(classes, kind.value));
        areas.push_back({kind, area(feature.parts)});
        if (feature.parts.empty()) continue;
        feature.numbers["class"] = kind.value;
        feature.texts = {{"label", kind.label()},
                         {"name", kind.name},
                         {"thresholds", kind.thresholds},
                         {"scheme", scheme.name},
                         {"source", scheme.source}};
        zones.features.push_back(std::move(feature));
    }
    zones.style =
        gis::polygon_style(zones.name, words("{1}, scheme {2}", {words("Intensity"), scheme.name}), "class", stops);
    gis::write_outlines(path, crs_wkt, {zones});
    gis::write_style(path, zones.style);
    return areas;
}

}  // namespace

std::optional<HazardScheme> hazard_scheme_of(const HazardSpec& spec) {
    if (!spec.scheme) return std::nullopt;
    return hazard_scheme(*spec.scheme,
                         {spec.depth_limits, spec.velocity_limits, spec.flux_limits, spec.pressure_limits});
}

std::vector<HazardArea> publish_hazard(const Prepared& prepared, const RunResult& result,
                                       const ResultDirectory& directory) {
    const std::optional<HazardScheme> scheme = hazard_scheme_of(prepared.spec.hazard);
    if (!scheme) return {};
    const std::map<std::string, std::string> origin = provenance(prepared);
    const Raster classes = intensity_classes(result, *scheme);
    const Words words = words_of(prepared.spec);
    write_raster(classes, *scheme, directory.path(std::string(k_hazard) + ".tif"), words, origin);
    return write_zones(classes, *scheme, directory.path(k_hazard_zones_file), prepared.scene.grid.crs_wkt, words);
}

}  // namespace frana::app
