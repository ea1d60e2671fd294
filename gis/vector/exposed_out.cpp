// SPDX-License-Identifier: Apache-2.0
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/utf8.h"
#include "gis/vector/exposed_in.h"
#include "gis/vector/geopackage.h"
#include "gis/vector/polygon_geometry.h"

namespace frana::gis {
namespace {

struct Kind {
    Shape shape;
    const char* ending;
    OGRwkbGeometryType type;
};
constexpr Kind k_kinds[] = {{Shape::area, "_areas", wkbMultiPolygon},
                            {Shape::line, "_lines", wkbMultiLineString},
                            {Shape::point, "_points", wkbMultiPoint}};

/// What a feature mostly is; areas before lines before points. None: it has no shape.
std::optional<Shape> shape_of(const ExposedFeature& feature) {
    if (!feature.shape.areas.empty()) return Shape::area;
    if (!feature.shape.lines.empty()) return Shape::line;
    if (!feature.shape.points.empty()) return Shape::point;
    return std::nullopt;
}

std::unique_ptr<OGRGeometry> geometry_of(const ExposedFeature& feature, Shape shape) {
    if (shape == Shape::area) return to_ogr(feature.shape.areas);
    if (shape == Shape::line) {
        auto all = std::make_unique<OGRMultiLineString>();
        for (const Polyline& one : feature.shape.lines) {
            OGRLineString line;
            for (const Point& place : one) line.addPoint(place.x, place.y);
            all->addGeometry(&line);
        }
        return all;
    }
    auto all = std::make_unique<OGRMultiPoint>();
    for (const Point& place : feature.shape.points) {
        const OGRPoint point(place.x, place.y);
        all->addGeometry(&point);
    }
    return all;
}

/// GeoPackage's own columns.
bool is_reserved(const std::string& name) {
    return EQUAL(name.c_str(), "fid") || EQUAL(name.c_str(), "geom");
}

bool write_features(OGRLayer& layer, Shape shape, const std::vector<const ExposedFeature*>& features) {
    std::set<std::string> numbers, texts;
    for (const ExposedFeature* feature : features) {
        for (const auto& [name, value] : feature->numbers) numbers.insert(name);
        for (const auto& [name, value] : feature->texts) texts.insert(name);
    }
    const auto create = [&](const std::string& name, OGRFieldType type) {
        OGRFieldDefn field(name.c_str(), type);
        return is_reserved(name) || layer.CreateField(&field) == OGRERR_NONE;
    };
    for (const std::string& name : numbers)
        if (!create(name, OFTReal)) return false;
    for (const std::string& name : texts)
        if (!create(name, OFTString)) return false;
    for (const ExposedFeature* feature : features) {
        OGRFeature row(layer.GetLayerDefn());
        for (const auto& [name, value] : feature->numbers)
            if (!is_reserved(name) && !std::isnan(value)) row.SetField(name.c_str(), value);
        for (const auto& [name, value] : feature->texts)
            if (!is_reserved(name)) row.SetField(name.c_str(), valid_utf8(value).c_str());
        if (!feature->shape.empty()) row.SetGeometryDirectly(geometry_of(*feature, shape).release());
        if (layer.CreateFeature(&row) != OGRERR_NONE) return false;
    }
    return true;
}

}  // namespace

void write_exposed(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& base,
                   const std::vector<ExposedFeature>& features, const std::map<Shape, StyleText>& styles) {
    std::map<Shape, std::vector<const ExposedFeature*>> by_shape;
    for (const ExposedFeature& feature : features)
        if (const auto shape = shape_of(feature)) by_shape[*shape].push_back(&feature);
    if (by_shape.empty()) by_shape[Shape::point];
    for (const ExposedFeature& feature : features)
        if (!shape_of(feature)) by_shape.begin()->second.push_back(&feature);
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        std::vector<LayerStyle> layer_styles;
        for (const Kind& kind : k_kinds) {
            const auto found = by_shape.find(kind.shape);
            if (found == by_shape.end()) continue;
            const std::string name = base + kind.ending;
            OGRLayer* const layer = dataset.CreateLayer(name.c_str(), crs, kind.type, nullptr);
            if (layer == nullptr || !write_features(*layer, kind.shape, found->second)) return false;
            if (const auto style = styles.find(kind.shape); style != styles.end())
                layer_styles.push_back({name, style->second});
        }
        return write_layer_styles(dataset, layer_styles);
    });
}

}  // namespace frana::gis
