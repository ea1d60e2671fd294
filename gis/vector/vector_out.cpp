// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_out.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/access/gdal_session.h"
#include "gis/vector/exposed_in.h"
#include "gis/vector/outline_check.h"

namespace frana::gis {
namespace {

/// Creates a GeoPackage aside, fills it by `write_layers(dataset, crs)`, which returns false on failure, and renames
/// it. An empty CRS becomes GeoPackage's undefined Cartesian one. Throws Error(environment).
void write_geopackage(const std::string& gpkg_path, const std::string& crs_wkt,
                      const std::function<bool(GDALDataset&, OGRSpatialReference*)>& write_layers) {
    const GdalSession session;
    FileAside file(gpkg_path, FileAside::Kind::named);  // SQLite creates its journal beside it
    OGRSpatialReference crs;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (crs_wkt.empty()) {
        crs.SetLocalCS("Undefined Cartesian SRS");  // GeoPackage's own name for plain metres
    } else {
        crs.importFromWkt(crs_wkt.c_str());
    }
    {
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
        const GDALDatasetUniquePtr dataset(
            driver ? driver->Create(file.partial_path().c_str(), 0, 0, 0, GDT_Unknown, nullptr) : nullptr);
        if (!dataset || !write_layers(*dataset, &crs)) session.refuse_written("the vector file", gpkg_path);
        dataset->FlushCache();
    }
    // Closing writes the last bytes and reports errors only through the error handler.
    if (session.failed()) session.refuse_written("the vector file", gpkg_path);
    file.sync_to_disk();
    file.rename_into_place();
}

/// Adds QGIS's table of styles, each the default of its layer. Returns false on failure.
bool write_layer_styles(GDALDataset& dataset, const std::vector<LayerStyle>& styles) {
    OGRLayer* table = dataset.CreateLayer(k_style_table, nullptr, wkbNone, nullptr);
    if (!table) return false;
    const auto column = [&](const char* name, OGRFieldType type, int width = 0, OGRFieldSubType subtype = OFSTNone) {
        OGRFieldDefn field(name, type);
        field.SetWidth(width);
        field.SetSubType(subtype);
        return table->CreateField(&field) == OGRERR_NONE;
    };
    // The columns that QGIS itself creates.
    const bool made = column("f_table_catalog", OFTString, 256) && column("f_table_schema", OFTString, 256) &&
                      column("f_table_name", OFTString, 256) && column("f_geometry_column", OFTString, 256) &&
                      column("styleName", OFTString, 30) && column("styleQML", OFTString) &&
                      column("styleSLD", OFTString) && column("useAsDefault", OFTInteger, 0, OFSTBoolean) &&
                      column("description", OFTString) && column("owner", OFTString, 30) &&
                      column("ui", OFTString, 30) && column("update_time", OFTDateTime);
    if (!made) return false;
    for (const LayerStyle& one : styles) {
        OGRLayer* const layer = dataset.GetLayerByName(one.layer.c_str());
        if (!layer) return false;
        OGRFeature row(table->GetLayerDefn());
        for (const char* unused : {"f_table_catalog", "f_table_schema", "owner"}) row.SetField(unused, "");
        row.SetField("f_table_name", one.layer.c_str());
        row.SetField("f_geometry_column", layer->GetGeometryColumn());
        row.SetField("styleName", one.layer.substr(0, 30).c_str());
        row.SetField("styleQML", one.style.qml.c_str());
        row.SetField("styleSLD", one.style.sld.c_str());
        row.SetField("useAsDefault", 1);
        row.SetField("description", "frana");
        row.SetField("update_time", 2000, 1, 1, 0, 0, 0, 100);  // the same bytes for the same result
        if (table->CreateFeature(&row) != OGRERR_NONE) return false;
    }
    return true;
}

bool write_layer(GDALDataset& dataset, OGRSpatialReference* crs, const std::string& name, const PointTable& table) {
    OGRLayer* layer = dataset.CreateLayer(name.c_str(), crs, wkbPoint, nullptr);
    if (!layer) return false;
    for (const PointTable::Column& column : table.columns) {
        OGRFieldDefn field(column.name.c_str(), OFTReal);
        if (layer->CreateField(&field) != OGRERR_NONE) return false;
    }
    for (std::size_t p = 0; p < table.places.size(); ++p) {
        OGRFeature row(layer->GetLayerDefn());
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const double value = table.columns[c].values[p];
            if (!std::isnan(value)) row.SetField(static_cast<int>(c), value);
        }
        row.SetGeometryDirectly(std::make_unique<OGRPoint>(table.places[p].x, table.places[p].y).release());
        if (layer->CreateFeature(&row) != OGRERR_NONE) return false;
    }
    return true;
}

}  // namespace

void write_points(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& layer_name,
                  const PointTable& table) {
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        // One transaction: otherwise every row would be written to disk separately.
        return dataset.StartTransaction() == OGRERR_NONE && write_layer(dataset, crs, layer_name, table) &&
               write_layer_styles(dataset, {{layer_name, style_of(layer_name, Shape::point, {})}}) &&
               dataset.CommitTransaction() == OGRERR_NONE;
    });
}

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
