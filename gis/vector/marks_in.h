// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/geometry.h"
#include "core/grid_spec.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

/// One line of a vector layer with its text attributes.
struct LineInput {
    Polyline line;
    std::map<std::string, std::string> texts;
};

struct LineInputLayer {
    std::vector<LineInput> features;  ///< in the target CRS
    std::string crs_wkt;              ///< of the file; empty: none
    std::string crs_label;            ///< of the file, for messages
    Bounds own_bounds;                ///< in the file's CRS
    TransformInfo transform;
};

/// Returns every line of a vector layer in the target CRS (empty: coordinates unchanged); "FILE|layer=NAME" selects one
/// of several layers. A line of several parts that join end to end is one line; curves become straight segments,
/// heights are dropped. `where` names the key. Throws Error(input): missing file, no CRS, no lines, parts that do not
/// join.
LineInputLayer read_lines(const std::string& path, const std::string& target_crs_wkt, const Place& where);

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

/// Points and lines of a vector layer: gauges, cross-sections, profile lines, surveyed fronts.
struct Marks {
    std::vector<NamedLine> lines;
    std::vector<NamedPoint> points;
    std::int64_t polygons = 0;  ///< number of polygon features; they are not read
    std::string crs_wkt;        ///< of the file; empty: none
    std::string crs_label;      ///< of the file, for messages
    Bounds own_bounds;          ///< in the file's CRS; of points and lines
    TransformInfo transform;
};

/// Returns points and lines in the target CRS (empty: coordinates unchanged). `path` may name a layer:
/// "file.gpkg|layer=gauges"; without it all layers are read. Parts of a collection become separate features. A name is
/// the attribute `name` (or NAME, Name, id), else a number from 1. Edges stay straight between their vertices. Throws
/// Error(input): missing file, no CRS, nothing in it, a place that cannot be transformed.
Marks read_marks(const std::string& path, const std::string& target_crs_wkt, const Place& where);

}  // namespace frana::gis
