// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/point_table.h"
#include "gis/vector/vector_style.h"

namespace frana::gis {

/// Writes a GeoPackage with one layer of points and a column of real numbers for each of the table's; NaN becomes NULL.
/// Written aside and renamed. An empty CRS is stored as undefined. Throws Error(environment).
void write_points(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& layer_name,
                  const PointTable& table);

/// The style of a layer.
struct LayerStyle {
    std::string layer;
    StyleText style;
};

/// Name of QGIS's table of styles, which is no layer.
inline constexpr const char* k_style_table = "layer_styles";

struct OutlineLayer {
    std::string name;  ///< "release", "trace", "deposit"
    std::vector<PolygonFeature> features;
    StyleText style{};  ///< empty: outlines of the default look
};

/// A line or a point with its attributes.
struct LineFeature {
    Polyline line;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};
struct PointFeature {
    Point place;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};
struct LineLayer {
    std::string name;
    std::vector<LineFeature> features;
    StyleText style{};
};
struct PointLayer {
    std::string name;
    std::vector<PointFeature> features;
    StyleText style{};
};

/// Writes a GeoPackage with one multipolygon layer per entry, with an area_m2 column and the features' own attributes,
/// each with its style, which QGIS uses without being asked (table layer_styles).
/// Written aside and renamed. An empty CRS is stored as undefined. Throws Error(environment).
void write_outlines(const std::string& gpkg_path, const std::string& crs_wkt, const std::vector<OutlineLayer>& layers);

/// Writes a GeoPackage of lines (with their length_m) and points; NaN attributes become NULL. Otherwise as
/// write_outlines.
void write_lines_and_points(const std::string& gpkg_path, const std::string& crs_wkt,
                            const std::vector<LineLayer>& lines, const std::vector<PointLayer>& points);

}  // namespace frana::gis
