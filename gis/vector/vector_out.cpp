// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_out.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "core/utf8.h"
#include "gis/vector/geopackage.h"
#include "gis/vector/polygon_geometry.h"

namespace frana::gis {
namespace {

struct Fields {
    std::set<std::string> numbers, texts;
};

/// Conversion of one kind of feature to OGR's: its measure in a separate column, if it has one, and its shape.
struct OutlineKind {
    static constexpr OGRwkbGeometryType type = wkbMultiPolygon;
    static constexpr const char* measure = "area_m2";
    static double measured(const PolygonFeature& feature) { return area(feature.parts); }
    static std::unique_ptr<OGRGeometry> shape(const PolygonFeature& feature) { return to_ogr(feature.parts); }
};
struct LineKind {
    static constexpr OGRwkbGeometryType type = wkbLineString;
    static constexpr const char* measure = "length_m";
    static double measured(const LineFeature& feature) {
        double sum = 0;
        for (std::size_t i = 1; i < feature.line.size(); ++i)
            sum += std::hypot(feature.line[i].x - feature.line[i - 1].x, feature.line[i].y - feature.line[i - 1].y);
        return sum;
    }
    static std::unique_ptr<OGRGeometry> shape(const LineFeature& feature) {
        auto line = std::make_unique<OGRLineString>();
        for (const Point& place : feature.line) line->addPoint(place.x, place.y);
        return line;
    }
};
struct PointKind {
    static constexpr OGRwkbGeometryType type = wkbPoint;
    static constexpr const char* measure = nullptr;
    static double measured(const PointFeature&) { return 0; }
    static std::unique_ptr<OGRGeometry> shape(const PointFeature& feature) {
        return std::make_unique<OGRPoint>(feature.place.x, feature.place.y);
    }
};

/// GeoPackage reserves two names, and the measure's is used; an attribute may not have them.
template <class Kind>
bool reserved(const std::string& name) {
    if constexpr (Kind::measure != nullptr) {
        if (EQUAL(name.c_str(), Kind::measure)) return true;
    }
    return EQUAL(name.c_str(), "fid") || EQUAL(name.c_str(), "geom");
}

template <class Kind, class Feature>
Fields fields_of(const std::vector<Feature>& features) {
    Fields fields;
    for (const Feature& feature : features) {
        for (const auto& [name, value] : feature.numbers) {
            if (!reserved<Kind>(name)) fields.numbers.insert(name);
        }
        for (const auto& [name, value] : feature.texts) {
            if (!reserved<Kind>(name)) fields.texts.insert(name);
        }
    }
    // A name that is a number in one feature and text in another is stored as a number where it is one.
    for (const std::string& name : fields.numbers) fields.texts.erase(name);
    return fields;
}

template <class Kind, class Feature>
bool write_layer(GDALDataset& dataset, OGRSpatialReference* crs, const std::string& layer_name,
                 const std::vector<Feature>& features) {
    OGRLayer* layer = dataset.CreateLayer(layer_name.c_str(), crs, Kind::type, nullptr);
    if (!layer) return false;
    const Fields fields = fields_of<Kind>(features);
    const auto create = [&](const std::string& name, OGRFieldType type) {
        OGRFieldDefn field(name.c_str(), type);
        return layer->CreateField(&field) == OGRERR_NONE;
    };
    if constexpr (Kind::measure != nullptr) {
        if (!create(Kind::measure, OFTReal)) return false;
    }
    for (const std::string& name : fields.numbers) {
        if (!create(name, OFTReal)) return false;
    }
    for (const std::string& name : fields.texts) {
        if (!create(name, OFTString)) return false;
    }
    for (const Feature& feature : features) {
        OGRFeature row(layer->GetLayerDefn());
        if constexpr (Kind::measure != nullptr) row.SetField(Kind::measure, Kind::measured(feature));
        for (const auto& [name, value] : feature.numbers) {
            if (!reserved<Kind>(name) && !std::isnan(value)) row.SetField(name.c_str(), value);
        }
        for (const auto& [name, value] : feature.texts) {
            if (fields.texts.count(name) > 0) row.SetField(name.c_str(), valid_utf8(value).c_str());
        }
        row.SetGeometryDirectly(Kind::shape(feature).release());
        if (layer->CreateFeature(&row) != OGRERR_NONE) return false;
    }
    return true;
}

template <class Layer>
void add_styles(const std::vector<Layer>& layers, Shape shape, std::vector<LayerStyle>& styles) {
    for (const Layer& layer : layers)
        styles.push_back({layer.name, layer.style.qml.empty() ? style_of(layer.name, shape, {}) : layer.style});
}

}  // namespace

void write_outlines(const std::string& gpkg_path, const std::string& crs_wkt, const std::vector<OutlineLayer>& layers) {
    std::vector<LayerStyle> styles;
    add_styles(layers, Shape::area, styles);
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        return std::all_of(layers.begin(), layers.end(),
                           [&](const OutlineLayer& layer) {
                               return write_layer<OutlineKind>(dataset, crs, layer.name, layer.features);
                           }) &&
               write_layer_styles(dataset, styles);
    });
}

void write_lines_and_points(const std::string& gpkg_path, const std::string& crs_wkt,
                            const std::vector<LineLayer>& lines, const std::vector<PointLayer>& points) {
    std::vector<LayerStyle> styles;
    add_styles(lines, Shape::line, styles);
    add_styles(points, Shape::point, styles);
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        return std::all_of(lines.begin(), lines.end(),
                           [&](const LineLayer& layer) {
                               return write_layer<LineKind>(dataset, crs, layer.name, layer.features);
                           }) &&
               std::all_of(points.begin(), points.end(),
                           [&](const PointLayer& layer) {
                               return write_layer<PointKind>(dataset, crs, layer.name, layer.features);
                           }) &&
               write_layer_styles(dataset, styles);
    });
}

}  // namespace frana::gis
