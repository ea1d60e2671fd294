// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/words/sentence.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

/// Converts to GDAL's polygon, rings closed.
std::unique_ptr<OGRPolygon> to_ogr(const Polygon& polygon);
std::unique_ptr<OGRMultiPolygon> to_ogr(const MultiPolygon& polygons);

/// Converts from GDAL's polygon; rings of fewer than three different points are omitted.
std::optional<Polygon> from_ogr(const OGRPolygon& polygon);

/// No map extends further, whatever its unit.
inline constexpr double k_furthest = 1e9;

/// The polygons in any geometry: curves made straight, collections opened, closed lines read as polygons.
struct PolygonParts {
    std::vector<std::unique_ptr<OGRPolygon>> polygons;
    int closed_lines = 0;   ///< read as polygons
    int open_lines = 0;     ///< ignored, including polygons with a ring that is not closed
    double widest_gap = 0;  ///< of the open lines [CRS units]
    int others = 0;         ///< points and other geometries without area
    int unbounded = 0;      ///< ignored: a coordinate is NaN or beyond k_furthest
};
PolygonParts polygon_parts(const OGRGeometry& geometry);

/// Returns a polygon in another CRS, its edges curved as by the projection, to `tolerance` [target units].
Polygon transformed(const Polygon& polygon, const CrsTransform& transform, double tolerance);

/// The result of checking an outline. Either `crossing` or `hole_outside` is set or `polygons` is not empty, or none of
/// these if no area is left.
struct OutlineCheck {
    std::vector<std::unique_ptr<OGRPolygon>> polygons;  ///< as given, or repaired
    std::optional<std::string> crossing;                ///< where it crosses itself: "at 526950.2, 5094120.7"
    std::optional<std::string> hole_outside;            ///< where it has a hole outside the area
    std::vector<Sentence> repairs;                      ///< list of repairs
};

/// Checks the polygons of one feature. One that crosses itself, or has a hole outside, has no well-defined interior and
/// is not repaired; one
/// that only touches itself is repaired, and so are parts that overlap (their union counts once).
OutlineCheck check_outline(std::vector<std::unique_ptr<OGRPolygon>> polygons);

}  // namespace frana::gis
