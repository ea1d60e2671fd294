// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_out.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
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

using Numbers = std::map<std::string, double>;
using Texts = std::map<std::string, std::string>;

/// A feature of any kind as OGR takes it.
struct Row {
    std::unique_ptr<OGRGeometry> shape;  ///< null: none
    double measured = 0;                 ///< in the layer's column of measure
    const Numbers* numbers;
    const Texts* texts;
    std::string look{};  ///< of itself, as GDAL writes styles
};

struct RowLayer {
    std::string name;
    OGRwkbGeometryType type;
    const char* measure;  ///< its column; null: none
    std::vector<Row> rows;
    StyleText style;
    std::vector<const char*> options{nullptr};  ///< of the format
};

std::unique_ptr<OGRLineString> line_of(const Polyline& line) {
    auto made = std::make_unique<OGRLineString>();
    for (const Point& place : line) made->addPoint(place.x, place.y);
    return made;
}

/// How a layer of one kind of shape is written, and its column of measure.
struct Kind {
    Shape shape;
    OGRwkbGeometryType type;
    const char* measure;
};
constexpr Kind k_kinds[] = {{Shape::area, wkbMultiPolygon, "area_m2"},
                            {Shape::line, wkbLineString, "length_m"},
                            {Shape::point, wkbPoint, nullptr}};

double measure_of(const MixedShape& shape, Shape kind) {
    if (kind != Shape::line) return area(shape.areas);
    const Polyline& line = shape.lines.at(0);
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    return length;
}

/// Writes the features with a column for each attribute. GeoPackage reserves two names, and the measure's is used; a
/// name that is a number in one feature and text in another is a number where it is one. NaN becomes NULL.
bool write_rows(GDALDataset& dataset, OGRSpatialReference* crs, RowLayer& from) {
    OGRLayer* const layer =
        dataset.CreateLayer(from.name.c_str(), crs, from.type, const_cast<char**>(from.options.data()));
    if (layer == nullptr) return false;
    const auto reserved = [&](const std::string& name) {
        return EQUAL(name.c_str(), "fid") || EQUAL(name.c_str(), "geom") ||
               (from.measure != nullptr && EQUAL(name.c_str(), from.measure));
    };
    std::set<std::string> numbers, texts;
    for (const Row& row : from.rows) {
        for (const auto& [name, value] : *row.numbers)
            if (!reserved(name)) numbers.insert(name);
        for (const auto& [name, value] : *row.texts)
            if (!reserved(name)) texts.insert(name);
    }
    std::map<std::string, int> places;  // formats shorten names
    const auto create = [&](const std::string& name, OGRFieldType type) {
        OGRFieldDefn field(name.c_str(), type);
        if (layer->CreateField(&field) != OGRERR_NONE) return false;
        const int known = layer->GetLayerDefn()->GetFieldIndex(name.c_str());
        places[name] = known >= 0 ? known : layer->GetLayerDefn()->GetFieldCount() - 1;
        return true;
    };
    if (from.measure != nullptr && !create(from.measure, OFTReal)) return false;
    for (const std::string& name : numbers)
        if (texts.erase(name); !create(name, OFTReal)) return false;
    for (const std::string& name : texts)
        if (!create(name, OFTString)) return false;
    for (Row& row : from.rows) {
        OGRFeature feature(layer->GetLayerDefn());
        if (from.measure != nullptr) feature.SetField(from.measure, row.measured);
        for (const auto& [name, value] : *row.numbers)
            if (numbers.count(name) > 0 && !std::isnan(value)) feature.SetField(places.at(name), value);
        for (const auto& [name, value] : *row.texts)
            if (texts.count(name) > 0)  // a drawing has its own letters
                feature.SetField(places.at(name), (from.type == wkbUnknown ? value : valid_utf8(value)).c_str());
        if (!row.look.empty()) feature.SetStyleString(row.look.c_str());
        if (row.shape) feature.SetGeometryDirectly(row.shape.release());
        if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
    }
    return true;
}

void write_layers(const std::string& gpkg_path, const std::string& crs_wkt, std::vector<RowLayer> layers) {
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        std::vector<LayerStyle> styles;
        for (RowLayer& layer : layers) {
            if (!write_rows(dataset, crs, layer)) return false;
            if (!layer.style.qml.empty()) styles.push_back({layer.name, layer.style});
        }
        return write_layer_styles(dataset, styles);
    });
}

bool write_table(GDALDataset& dataset, OGRSpatialReference* crs, const std::string& name, const PointTable& table) {
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

/// What a feature mostly is; areas before lines before points. None: it has no shape.
std::optional<Shape> shape_of(const MixedShape& shape) {
    if (!shape.areas.empty()) return Shape::area;
    if (!shape.lines.empty()) return Shape::line;
    if (!shape.points.empty()) return Shape::point;
    return std::nullopt;
}

/// Of a single line or point, or of all of one kind.
std::unique_ptr<OGRGeometry> geometry_of(const MixedShape& mixed, OGRwkbGeometryType type) {
    switch (type) {
        case wkbLineString:
            return line_of(mixed.lines.at(0));
        case wkbPoint:
            return std::make_unique<OGRPoint>(mixed.points.at(0).x, mixed.points.at(0).y);
        case wkbMultiLineString: {
            auto all = std::make_unique<OGRMultiLineString>();
            for (const Polyline& one : mixed.lines) all->addGeometryDirectly(line_of(one).release());
            return all;
        }
        case wkbMultiPoint: {
            auto all = std::make_unique<OGRMultiPoint>();
            for (const Point& place : mixed.points) all->addGeometryDirectly(new OGRPoint(place.x, place.y));
            return all;
        }
        default:
            return to_ogr(mixed.areas);
    }
}

}  // namespace

void write_points(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& layer_name,
                  const PointTable& table) {
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        // One transaction: otherwise every row would be written to disk separately.
        return dataset.StartTransaction() == OGRERR_NONE && write_table(dataset, crs, layer_name, table) &&
               write_layer_styles(dataset, {{layer_name, style_of(layer_name, Shape::point, {})}}) &&
               dataset.CommitTransaction() == OGRERR_NONE;
    });
}

void write_mixed(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& base,
                 const std::vector<Feature>& features, const std::map<Shape, StyleText>& styles) {
    constexpr std::tuple<Shape, const char*, OGRwkbGeometryType> k_several[] = {
        {Shape::area, "_areas", wkbMultiPolygon},
        {Shape::line, "_lines", wkbMultiLineString},
        {Shape::point, "_points", wkbMultiPoint}};
    std::set<Shape> shapes;
    for (const Feature& feature : features)
        if (const auto shape = shape_of(feature.shape)) shapes.insert(*shape);
    if (shapes.empty()) shapes.insert(Shape::point);
    std::vector<RowLayer> layers;
    for (const auto& [shape, ending, type] : k_several) {
        if (shapes.count(shape) == 0) continue;
        const auto style = styles.find(shape);
        RowLayer& layer = layers.emplace_back(
            RowLayer{base + ending, type, nullptr, {}, style == styles.end() ? StyleText{} : style->second});
        for (const Feature& feature : features)
            if (shape_of(feature.shape).value_or(*shapes.begin()) == shape)
                layer.rows.push_back({feature.shape.empty() ? nullptr : geometry_of(feature.shape, type), 0,
                                      &feature.numbers, &feature.texts});
    }
    write_layers(gpkg_path, crs_wkt, std::move(layers));
}

void write_shapes(const std::string& gpkg_path, const std::string& crs_wkt, const std::vector<ShapeLayer>& layers) {
    std::vector<RowLayer> all;
    std::set<std::string> descriptions;
    for (const ShapeLayer& layer : layers) {
        const auto& [shape, type, measure] = *std::find_if(std::begin(k_kinds), std::end(k_kinds),
                                                           [&](const Kind& one) { return one.shape == layer.shape; });
        RowLayer& made = all.emplace_back(RowLayer{
            layer.name, type, measure, {}, layer.style.qml.empty() ? style_of(layer.name, shape, {}) : layer.style});
        if (!layer.description.empty())
            made.options = {descriptions.insert("DESCRIPTION=" + layer.description).first->c_str(), nullptr};
        for (const Feature& one : layer.features)
            made.rows.push_back({geometry_of(one.shape, type), measure_of(one.shape, shape), &one.numbers, &one.texts});
    }
    write_layers(gpkg_path, crs_wkt, std::move(all));
}

namespace {

/// A file for other programs.
struct ExchangeFormat {
    const char *ending, *driver;
    std::vector<const char*> options;
};
const ExchangeFormat k_exchange_formats[] = {
    {".shp", "ESRI Shapefile", {"ENCODING=UTF-8", "DBF_DATE_LAST_UPDATE=2000-01-01", nullptr}},  // the same bytes
    {".kmz", "LIBKML", {nullptr}},
    {".dxf", "DXF", {nullptr}}};

/// The texts of a placemark, or of an entity of a drawing, whose letters are those of Western Europe.
Texts exchange_texts(const Zone& zone, bool is_drawing) {
    Texts texts = zone.feature.texts;
    texts.erase("name");  // columns of a Shapefile differ in more than case
    texts["Name"] = zone.name;
    if (!is_drawing) return texts;
    char* const name = CPLRecode(zone.name.c_str(), CPL_ENC_UTF8, "CP1252");
    texts = {{"Layer", name}};
    CPLFree(name);
    return texts;
}

/// Rings that nearly touch may cross once their places are rounded to degrees, which KML refuses.
std::unique_ptr<OGRMultiPolygon> valid_parts(const OGRMultiPolygon& shape) {
    const GdalSession session;
    const std::unique_ptr<OGRGeometry> sound(shape.MakeValid());
    auto parts = std::make_unique<OGRMultiPolygon>();
    for (const auto& part : polygon_parts(sound ? *sound : static_cast<const OGRGeometry&>(shape)).polygons)
        if (part->IsValid()) parts->addGeometry(part.get());
    return parts;
}

}  // namespace

void write_zones(const std::string& path, const std::string& crs_wkt, const std::vector<Zone>& zones) {
    const GdalSession session;
    const std::filesystem::path target(path);
    const auto& format = *std::find_if(std::begin(k_exchange_formats), std::end(k_exchange_formats),
                                       [&](const ExchangeFormat& one) { return target.extension() == one.ending; });
    const bool in_degrees = path.ends_with(".kmz"), is_drawing = path.ends_with(".dxf");
    OGRSpatialReference crs, degrees;
    if (!crs_wkt.empty()) crs.importFromWkt(crs_wkt.c_str());
    degrees.importFromEPSG(4326);
    for (OGRSpatialReference* one : {&crs, &degrees}) one->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> to_degrees(
        in_degrees ? OGRCreateCoordinateTransformation(&crs, &degrees) : nullptr);
    RowLayer layer{target.stem().string(), is_drawing ? wkbUnknown : wkbMultiPolygon, nullptr, {}, {}, format.options};
    std::vector<Texts> texts;
    for (const Zone& zone : zones) texts.push_back(exchange_texts(zone, is_drawing));
    const Numbers none;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const std::string colour = hex(zones[i].colour), pen = "PEN(c:" + colour + ",w:2px)";
        const auto add = [&](std::unique_ptr<OGRGeometry> shape) {
            layer.rows.push_back({std::move(shape), 0, is_drawing ? &none : &zones[i].feature.numbers, &texts[i],
                                  is_drawing ? pen : pen + ";BRUSH(fc:" + colour + "80)"});
        };
        auto shape = to_ogr(zones[i].feature.shape.areas);
        if (to_degrees && shape->transform(to_degrees.get()) != OGRERR_NONE)
            session.refuse_written("the vector file", path);
        if (to_degrees) shape = valid_parts(*shape);
        for (const OGRPolygon* polygon : is_drawing ? *shape : OGRMultiPolygon())
            for (const OGRLinearRing* ring : *polygon)
                add(std::make_unique<OGRLineString>(*ring));  // hatches are stiff
        if (!is_drawing) add(std::move(shape));
    }
    const MemoryFolder memory;
    {
        GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(format.driver);
        const GDALDatasetUniquePtr dataset(
            driver ? driver->Create(memory.place_of(path).c_str(), 0, 0, 0, GDT_Unknown, nullptr) : nullptr);
        if (!dataset || !write_rows(*dataset, in_degrees ? &degrees : crs_wkt.empty() ? nullptr : &crs, layer))
            session.refuse_written("the vector file", path);
    }
    if (session.failed()) session.refuse_written("the vector file", path);
    memory.write_to_disk(path);
}

}  // namespace frana::gis
