// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/grid_spec.h"

namespace frana {

/// A closed ring; the last point is not repeated. At least three points.
using Ring = std::vector<Point>;
using Polyline = std::vector<Point>;

/// An outline with its holes, in map coordinates of the working CRS.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
};
using MultiPolygon = std::vector<Polygon>;

/// One feature of a vector layer: its polygons and its numeric attributes (text attributes are kept as text).
struct PolygonFeature {
    MultiPolygon parts;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};

/// Returns the area of a ring [m2], positive for either orientation.
double area(const Ring& ring);
/// Returns the area of a polygon [m2]: outer ring minus its holes.
double area(const Polygon& polygon);
double area(const MultiPolygon& polygons);

/// Returns whether a point is inside (even-odd rule, holes excluded). Points exactly on an edge belong to one side
/// only, so that neighbours sharing an edge never count a point twice.
bool contains(const Ring& ring, Point point);
bool contains(const Polygon& polygon, Point point);
bool contains(const MultiPolygon& polygons, Point point);

/// Returns the smallest rectangle around all outer rings; all zero if there is none.
Bounds bounds(const MultiPolygon& polygons);

}  // namespace frana
