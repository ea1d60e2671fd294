// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"
#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "core/words/words.h"
#include "simulation/result.h"

namespace frana::app {

/// A class and its area: that of its cells, and that of its zones as people would draw them; NaN: there are none.
struct HazardArea {
    HazardClass kind;
    double area_m2 = 0, zones_m2 = k_no_data;
};

/// Layer of a GeoPackage of classes with their generalised zones.
inline constexpr const char* k_generalised_layer = "generalised";

/// Returns the scheme that a scene names; none without one.
std::optional<HazardScheme> hazard_scheme_of(const SceneSpec& scene);

/// The least depth of a scheme, then what its intensities mean, for the legend of a map of something else: "medium:
/// depth <= 1 m ..."; a line for each.
std::vector<std::string> intensity_limits(const HazardScheme& scheme);

/// A raster of classes with its texts.
struct ClassMap {
    std::string name;   ///< row of the table of result rasters: "hazard"
    std::string title;  ///< "Intensity"
    std::vector<HazardClass> classes;
    HazardScheme scheme;  ///< of the intensities
    std::string source;
    std::string zones_file;           ///< of its polygons
    std::vector<std::string> limits;  ///< the least depth, then those of the intensities behind the classes
};

/// Writes it, its polygons and their styles; the polygons as the cells have them, and generalised after the scheme, of
/// which output.formats may ask for other files. Returns the classes' areas. Throws Error(environment).
std::vector<HazardArea> publish_classes(const Raster& classes, const ClassMap& map,
                                        const std::map<std::string, std::string>& metadata, const SceneSpec& spec,
                                        const ResultDirectory& directory);

/// Writes hazard.tif, hazard_zones.gpkg (one feature per class) and their styles, if the scene names a scheme; also
/// max_flux.tif and max_head.tif if they were recorded. Returns the classes' areas; none without a scheme. Throws
/// Error(environment).
std::vector<HazardArea> publish_hazard(const Prepared& prepared, const RunResult& result,
                                       const ResultDirectory& directory);

}  // namespace frana::app
