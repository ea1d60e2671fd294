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

namespace frana::gis {

/// A feature of any shape, in map coordinates.
struct Feature {
    MixedShape shape;                       ///< empty: without geometry
    std::map<std::string, double> numbers;  ///< NaN: none
    std::map<std::string, std::string> texts;
    std::string name{};             ///< of the name column, else its number in the file
    std::optional<double> count{};  ///< of the column of counts
    std::int64_t fid = 0;           ///< in its file
};

/// What a vector file is.
struct VectorFile {
    std::string layer_name, crs_wkt, crs_label;  ///< empty WKT: it has no CRS
    Bounds own_bounds;                           ///< in its own CRS
    TransformInfo transform;
};

struct FeatureLayer : VectorFile {
    std::vector<Feature> features;  ///< all of the file in its order, in the target CRS
};

/// Returns every feature of a vector layer of any shape in the target CRS (empty: coordinates unchanged), with its
/// attributes. `path` may name a layer: "file.gpkg|layer=houses". Curves become straight; heights are dropped. `where`
/// names the key. Throws Error(input): missing file, no CRS, no feature, an unknown column, a count that is no number,
/// a place that cannot be transformed.
/// @param name_column, count_column empty: none
FeatureLayer read_features(const std::string& path, const std::string& target_crs_wkt, const Place& where,
                           const std::string& name_column, const std::string& count_column);

/// Returns every line of a vector layer, each a feature of one line. A line of several parts that join end to end is
/// one; edges stay straight between their vertices. Otherwise as read_features; parts that do not join are an error.
FeatureLayer read_lines(const std::string& path, const std::string& target_crs_wkt, const Place& where);

/// Points of a vector layer with some of their numbers: `columns[k][i]` is the k-th requested number of point i.
struct ValuedPoints {
    std::vector<Point> places;
    std::vector<std::vector<double>> columns;
};

/// Returns the points of the only point layer of a file, in its own coordinates, with the named numeric attributes.
/// Throws Error(input): missing or damaged file, no such attribute.
ValuedPoints read_valued_points(const std::string& path, const std::vector<std::string>& names, const Place& where);

struct NamedLine {
    std::string name;
    Polyline line;
};

struct NamedPoint {
    std::string name;
    Point place;
};

/// Points and lines of a vector file: gauges, cross-sections, profile lines, surveyed fronts.
struct Marks : VectorFile {
    std::vector<NamedLine> lines;
    std::vector<NamedPoint> points;
    std::size_t polygons = 0;  ///< they are not read
};

/// Returns points and lines in the target CRS (empty: coordinates unchanged). `path` may name a layer:
/// "file.gpkg|layer=gauges"; without it all layers are read. Parts of a collection become separate features. A name is
/// the attribute `name` (or NAME, Name, id), else a number from 1. Edges stay straight between their vertices. Throws
/// Error(input): missing file, no CRS, nothing in it, a place that cannot be transformed.
Marks read_marks(const std::string& path, const std::string& target_crs_wkt, const Place& where);

}  // namespace frana::gis
