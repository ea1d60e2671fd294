// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/exposed_in.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/vector/outline_check.h"
#include "gis/vector/vector_source.h"

namespace frana::gis {
namespace {

constexpr double k_exposed_bend_tolerance = 1e-3;

void add_parts(const OGRGeometry& geometry, MixedShape& shape) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPoint: {
            const OGRPoint& point = *geometry.toPoint();
            if (!point.IsEmpty()) shape.points.push_back({point.getX(), point.getY()});
            return;
        }
        case wkbLineString: {
            Polyline line;
            for (const OGRPoint& point : *geometry.toLineString()) line.push_back({point.getX(), point.getY()});
            if (!line.empty()) shape.lines.push_back(std::move(line));
            return;
        }
        case wkbPolygon:
        case wkbTriangle:
            if (auto polygon = from_ogr(*geometry.toPolygon())) shape.areas.push_back(std::move(*polygon));
            return;
        case wkbMultiPoint:
        case wkbMultiLineString:
        case wkbMultiPolygon:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_parts(*part, shape);
            return;
        case wkbPolyhedralSurface:
        case wkbTIN:
            for (const OGRPolygon* part : *geometry.toPolyhedralSurface()) add_parts(*part, shape);
            return;
        default:
            return;
    }
}

template <class Visit>
void for_each_place(MixedShape& shape, const Visit& visit) {
    for (Point& point : shape.points) visit(point);
    for (Polyline& line : shape.lines)
        for (Point& point : line) visit(point);
    for (Polygon& area : shape.areas) {
        for (Point& point : area.outer) visit(point);
        for (Ring& hole : area.holes)
            for (Point& point : hole) visit(point);
    }
}

void read_attributes(const OGRFeature& from, ExposedFeature& feature) {
    const OGRFeatureDefn& fields = *from.GetDefnRef();
    for (int i = 0; i < fields.GetFieldCount(); ++i) {
        const OGRFieldDefn& field = *fields.GetFieldDefn(i);
        const OGRFieldType type = field.GetType();
        const bool is_number = type == OFTInteger || type == OFTInteger64 || type == OFTReal;
        const bool is_given = from.IsFieldSetAndNotNull(i);
        if (is_number)
            feature.numbers[field.GetNameRef()] = is_given ? from.GetFieldAsDouble(i) : std::nan("");
        else
            feature.texts[field.GetNameRef()] = is_given ? from.GetFieldAsString(i) : "";
    }
}

/// The place of a column; -1: none is asked for.
int column_of(OGRLayer& layer, const VectorSource& source, const std::string& column) {
    if (column.empty()) return -1;
    OGRFeatureDefn& fields = *layer.GetLayerDefn();
    const int index = fields.GetFieldIndex(column.c_str());
    if (index >= 0) return index;
    std::string names;
    for (int i = 0; i < fields.GetFieldCount(); ++i)
        names += (names.empty() ? "" : ", ") + std::string(fields.GetFieldDefn(i)->GetNameRef());
    throw vector_error(source, "the layer has no such column", column,
                       names.empty() ? "It has no attributes" : "Its columns are " + names);
}

std::optional<double> count_of(const OGRFeature& feature, int column, const VectorSource& source) {
    if (column < 0 || !feature.IsFieldSetAndNotNull(column)) return std::nullopt;
    const std::string text = feature.GetFieldAsString(column);
    char* end = nullptr;
    const double count = CPLStrtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !(count >= 0) || !std::isfinite(count))
        throw vector_error(source, "feature " + std::to_string(feature.GetFID()) + " has a count that is no number",
                           text, "Give numbers from 0, or another output.exposure-count");
    return count;
}

void transform_all(ExposedLayer& layer, const std::string& target, const VectorSource& source) {
    Bounds box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (ExposedFeature& feature : layer.features)
        for_each_place(feature.shape, [&](const Point& p) {
            box = {std::min(box.west, p.x), std::min(box.south, p.y), std::max(box.east, p.x),
                   std::max(box.north, p.y)};
        });
    if (box.west > box.east) return;
    layer.own_bounds = box;
    try {
        const CrsTransform transform(target.empty() ? "" : layer.crs_wkt, target, box);
        layer.transform = transform.info();
        if (transform.is_identity()) return;
        for (ExposedFeature& feature : layer.features) {
            for (Point& point : feature.shape.points) point = transform(point);
            for (Polyline& line : feature.shape.lines)
                for (Point& point : line) point = transform(point);
            for (Polygon& area : feature.shape.areas) area = transformed(area, transform, k_exposed_bend_tolerance);
        }
    } catch (const Error& error) {
        const Problem& first = error.problems().front();
        throw vector_error(source, first.what, first.value, first.remedy);
    }
}

}  // namespace

ExposedLayer read_exposed(const std::string& path, const std::string& target, const Place& where,
                          const std::string& name_column, const std::string& count_column) {
    const GdalSession session;
    const ReadingOnly reading;
    const VectorSource source = vector_source(path, where);
    TimeLimit limit(source.where);
    const GDALDatasetUniquePtr dataset = open_vector(source);
    OGRLayer& from = choose_layer(
        *dataset, source, [](OGRLayer& layer) { return layer.GetGeomType() != wkbNone; }, "points, lines or areas");
    check_attribute_table(*dataset, from, source);
    const int name = column_of(from, source, name_column), count = column_of(from, source, count_column);
    ExposedLayer layer;
    layer.layer_name = from.GetName();
    layer.crs_wkt = declared_crs(*dataset, from, source);
    layer.crs_label = layer.crs_wkt.empty() ? "none" : crs_name(layer.crs_wkt);
    if (layer.crs_wkt.empty() && !target.empty())
        throw vector_error(source, "the file names no coordinate reference system", "",
                           crs_remedy(source) + ", or use terrain.crs = local throughout");
    VertexCount vertices(source);
    from.ResetReading();
    for (const auto& one : from) {
        limit.again();
        const OGRGeometry* const geometry = one->GetGeometryRef();
        vertices.add(geometry);
        ExposedFeature& feature = layer.features.emplace_back();
        feature.fid = one->GetFID();
        if (geometry != nullptr) {
            const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
            add_parts(*straight, feature.shape);
        }
        feature.name =
            name >= 0 && one->IsFieldSetAndNotNull(name) ? one->GetFieldAsString(name) : std::to_string(one->GetFID());
        feature.count = count_of(*one, count, source);
        read_attributes(*one, feature);
    }
    require_sound(session, source);
    if (layer.features.empty()) throw vector_error(source, "the layer is empty", layer.layer_name, "Draw a feature");
    transform_all(layer, target, source);
    return layer;
}

}  // namespace frana::gis
