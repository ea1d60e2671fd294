// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/geometry.h"
#include "gis/crs/crs_transform.h"
#include "gis/vector/vector_style.h"

namespace frana::gis {

/// Something that a flow may hit: a building, a road, people at a place.
struct ExposedFeature {
    std::int64_t fid = 0;  ///< in its file
    std::string name;      ///< of the name column, else its number in the file
    std::optional<double> count;
    MixedShape shape;  ///< in the target CRS; empty: the file has no geometry for it
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};

struct ExposedLayer {
    std::vector<ExposedFeature> features;  ///< all of the file, in its order
    std::string layer_name, crs_wkt, crs_label;
    Bounds own_bounds;
    TransformInfo transform;
};

/// Returns every feature of a vector layer of any shape in the target CRS (empty: coordinates unchanged), with its
/// attributes. `path` may name a layer: "file.gpkg|layer=houses". Curves become straight; heights are dropped. `where`
/// names the key. Throws Error(input): missing file, no CRS, no feature, an unknown column, a count that is no number,
/// a place that cannot be transformed.
/// @param name_column, count_column empty: none
ExposedLayer read_exposed(const std::string& path, const std::string& target_crs_wkt, const Place& where,
                          const std::string& name_column, const std::string& count_column);

/// Writes such features with their attributes to a GeoPackage: a layer of areas, one of lines, one of points (those
/// that occur; a feature without geometry goes to the first). Attributes that are NaN are NULL. Written aside and
/// renamed. Throws Error(environment).
/// @param base of the names of the layers: "exposure" gives exposure_areas, exposure_lines, exposure_points
void write_exposed(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& base,
                   const std::vector<ExposedFeature>& features, const std::map<Shape, StyleText>& styles);

}  // namespace frana::gis
