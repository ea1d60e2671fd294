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

/// One feature of a vector layer: its parts and its numeric attributes (text attributes are kept as text).
struct PolygonFeature {
    MultiPolygon parts;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};

/// Area of a ring [m2], positive whatever its direction.
double area(const Ring& ring);
/// Area of a polygon [m2]: outer ring less its holes.
double area(const Polygon& polygon);
double area(const MultiPolygon& polygons);

/// Whether a point lies inside (even-odd rule, holes respected). Points exactly on an edge belong to one side
/// only, so that neighbours sharing an edge never count a point twice.
bool contains(const Ring& ring, Point point);
bool contains(const Polygon& polygon, Point point);
bool contains(const MultiPolygon& polygons, Point point);

/// The smallest rectangle round all outer rings; all zero when there is none.
Bounds bounds(const MultiPolygon& polygons);

}  // namespace frana
