// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/point_table.h"
#include "gis/vector/vector_in.h"
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

/// Features of one kind of shape.
struct ShapeLayer {
    std::string name;  ///< "release", "trace", "deposit"
    std::vector<Feature> features;
    Shape shape = Shape::area;
    StyleText style{};          ///< empty: the default look
    std::string description{};  ///< in the table of contents
};

/// Writes a GeoPackage with one layer per entry: of areas, each feature a multipolygon with its area_m2; of lines, each
/// feature one with its length_m; or of points. The features have their own attributes, NaN as NULL, and each layer its
/// style, which QGIS uses without being asked (table layer_styles).
/// Written aside and renamed. An empty CRS is stored as undefined. Throws Error(environment).
void write_shapes(const std::string& gpkg_path, const std::string& crs_wkt, const std::vector<ShapeLayer>& layers);

/// The same of features that may have several parts and any shape: a layer of areas, one of lines, one of points (those
/// that occur; a feature without geometry goes to the first).
/// @param base of the names of the layers: "exposure" gives exposure_areas, exposure_lines, exposure_points
void write_mixed(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& base,
                 const std::vector<Feature>& features, const std::map<Shape, StyleText>& styles);

/// A polygon of a map that people draw.
struct Zone {
    Feature feature;
    std::string name;  ///< as people read it: of a placemark, of a layer of a drawing
    Rgb colour{};
};

/// Writes zones for other programs, by the ending: PATH.shp and the files beside it, PATH.kmz (in degrees of WGS 84),
/// PATH.dxf (closed lines, a layer for each name; a drawing has no attributes). Throws Error(environment).
/// @param crs_wkt empty: plain metres, which a KMZ cannot be made of
void write_zones(const std::string& path, const std::string& crs_wkt, const std::vector<Zone>& zones);

/// The files of a Shapefile.
inline constexpr const char* k_shapefile_endings[] = {".shp", ".shx", ".dbf", ".prj", ".cpg"};

}  // namespace frana::gis
