// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

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
Marks read_marks(const std::string& path, const std::string& target_crs_wkt, const std::string& where);

}  // namespace frana::gis
