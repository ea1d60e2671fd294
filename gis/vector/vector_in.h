// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "core/geometry.h"
#include "core/words/sentence.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

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

/// Areas of one layer.
struct PolygonLayer : FeatureLayer {
    std::vector<std::string> conditions;  ///< for each feature the SQL condition that it alone satisfies: "fid = 3"
    std::vector<std::string> unusable;    ///< for each feature why it has no area; empty: it has one
    Bounds bounds;                        ///< in the target CRS
    std::vector<Sentence> warnings;
};

/// Options for reading a vector file; an empty text leaves the choice to the file.
struct LayerChoice {
    std::string filter;  ///< SQL condition on the attributes ("kind = 'release'")
    std::string crs;     ///< WKT, replaces that of the file
    bool keep_unusable =
        false;  ///< features that are no area stay in their place, without parts; else they are refused

    [[nodiscard]] auto members() const { return std::tie(filter, crs, keep_unusable); }
};

/// Returns every polygon of a vector layer in the target CRS (empty: coordinates unchanged). `path` may name a layer:
/// "file.gpkg|layer=release". Curves become straight segments, heights are dropped, closed lines count as polygons,
/// long edges are curved as by the projection (to 1 mm). An outline that touches itself is repaired with a warning; one
/// that crosses itself is refused with the place. `where` names the key. Throws Error(input) with every feature's
/// problem: missing file, no CRS, empty layer, no polygon, crossing (unless choice.keep_unusable).
PolygonLayer read_polygons(const std::string& path, const std::string& target_crs_wkt, const Place& where,
                           const LayerChoice& choice = {});

/// Returns the names of the layers of a result's vector file that have a feature. Throws Error(input) if the file
/// cannot be read completely.
std::set<std::string> filled_layers(const std::string& file, const Place& where);

}  // namespace frana::gis
