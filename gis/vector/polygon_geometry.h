// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

/// GDAL's polygon of ours, rings closed.
std::unique_ptr<OGRPolygon> to_ogr(const Polygon& polygon);
std::unique_ptr<OGRMultiPolygon> to_ogr(const MultiPolygon& polygons);

/// Ours of GDAL's; rings of fewer than three different points are left out.
std::optional<Polygon> from_ogr(const OGRPolygon& polygon);

/// Further out no map reaches, whatever its unit.
inline constexpr double k_furthest = 1e9;

/// The polygons inside any geometry: curves made straight, collections opened, closed lines taken as
/// polygons.
struct PolygonParts {
    std::vector<std::unique_ptr<OGRPolygon>> polygons;
    int closed_lines = 0;   ///< taken as polygons
    int open_lines = 0;     ///< left out, polygons with a ring that does not close among them
    double widest_gap = 0;  ///< of the open lines [CRS units]
    int others = 0;         ///< points and what else is no area
    int unbounded = 0;      ///< left out: a coordinate of theirs is NaN or beyond k_furthest
};
PolygonParts polygon_parts(const OGRGeometry& geometry);

/// A polygon in another CRS, its edges bent as the projection bends them, to `tolerance` [target units].
Polygon transformed(const Polygon& polygon, const CrsTransform& transform, double tolerance);

}  // namespace frana::gis
