// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/marks_in.h"

#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>

#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/vector/vector_source.h"

namespace frana::gis {
namespace {

/// Returns the line of a feature; parts that join are merged.
Polyline line_of(const OGRFeature& feature, const VectorSource& source) {
    const std::string name = "feature " + std::to_string(feature.GetFID());
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) throw vector_error(source, name + " has no geometry", "", "Draw a line");
    std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
    if (wkbFlatten(straight->getGeometryType()) == wkbMultiLineString) {
        straight.reset(OGRGeometryFactory::forceToLineString(straight.release()));
    }
    if (wkbFlatten(straight->getGeometryType()) != wkbLineString) {
        const bool parts = wkbFlatten(straight->getGeometryType()) == wkbMultiLineString;
        throw vector_error(source, name + (parts ? " has parts that do not join" : " is not a line"),
                           straight->getGeometryName(), "Draw one line per inflow");
    }
    Polyline line;
    for (const OGRPoint& point : *straight->toLineString()) line.push_back({point.getX(), point.getY()});
    return line;
}

}  // namespace

LineInputLayer read_lines(const std::string& path, const std::string& target_crs_wkt, const Place& where) {
    const GdalSession session;
    const ReadingOnly reading;
    const VectorSource source = vector_source(path, where);
    TimeLimit limit(source.where);
    const GDALDatasetUniquePtr dataset = open_vector(source);
    OGRLayer& layer = choose_layer(
        *dataset, source, [](OGRLayer&) { return true; }, "lines");
    const std::string crs = declared_crs(*dataset, layer, source);
    if (crs.empty() && !target_crs_wkt.empty())
        throw vector_error(source, "the file names no coordinate reference system", "",
                           crs_remedy(source) + ", or use terrain.crs = local throughout");
    LineInputLayer read;
    read.crs_wkt = crs;
    read.crs_label = crs.empty() ? "none" : crs_name(crs);
    MultiPolygon all;
    layer.ResetReading();
    VertexCount vertices(source);
    for (const auto& from : layer) {
        limit.again();
        vertices.add(from->GetGeometryRef());
        LineInput feature{line_of(*from, source), {}};
        for (int i = 0; i < from->GetFieldCount(); ++i) {
            if (from->IsFieldSetAndNotNull(i))
                feature.texts[from->GetFieldDefnRef(i)->GetNameRef()] = from->GetFieldAsString(i);
        }
        all.push_back({feature.line, {}});
        read.features.push_back(std::move(feature));
    }
    require_sound(session, source);
    if (read.features.empty()) throw vector_error(source, "the layer is empty", layer.GetName(), "Draw a line");
    read.own_bounds = bounds(all);
    try {
        const CrsTransform transform(target_crs_wkt.empty() ? "" : crs, target_crs_wkt, read.own_bounds);
        read.transform = transform.info();
        for (LineInput& feature : read.features) {
            for (Point& point : feature.line) point = transform(point);
        }
    } catch (const Error& error) {
        throw vector_error(source, error.problems().front().what, error.problems().front().value,
                           error.problems().front().remedy);
    }
    return read;
}

ValuedPoints read_valued_points(const std::string& path, const std::vector<std::string>& names, const Place& where) {
    const GdalSession session;
    const ReadingOnly reading;
    const VectorSource source = vector_source(path, where);
    TimeLimit limit(source.where);
    const GDALDatasetUniquePtr dataset = open_vector(source);
    OGRLayer& layer = choose_layer(
        *dataset, source, [](OGRLayer& one) { return wkbFlatten(one.GetGeomType()) == wkbPoint; }, "points");
    std::vector<int> fields;
    for (const std::string& name : names) {
        fields.push_back(layer.GetLayerDefn()->GetFieldIndex(name.c_str()));
        if (fields.back() < 0)
            throw vector_error(source, "the layer has no such attribute", name, "Take a file that frana wrote");
    }
    ValuedPoints points;
    points.columns.resize(names.size());
    for (const auto& feature : layer) {
        limit.again();
        const OGRGeometry* geometry = feature->GetGeometryRef();
        if (geometry == nullptr || geometry->IsEmpty()) continue;
        const OGRPoint& point = *geometry->toPoint();
        points.places.push_back({point.getX(), point.getY()});
        for (std::size_t k = 0; k < fields.size(); ++k)
            points.columns[k].push_back(feature->GetFieldAsDouble(fields[k]));
    }
    require_sound(session, source, "Run the scene again");
    return points;
}

namespace {

std::string name_of(const OGRFeature& feature) {
    for (const char* field : {"name", "NAME", "Name", "id"}) {
        const int index = feature.GetFieldIndex(field);
        if (index >= 0 && feature.IsFieldSetAndNotNull(index)) return feature.GetFieldAsString(index);
    }
    return {};
}

std::string numbered(const std::string& name, std::size_t before) {
    return name.empty() ? std::to_string(before + 1) : name;
}

void add_marks(const OGRGeometry& geometry, const std::string& name, Marks& marks) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPoint: {
            const OGRPoint& point = *geometry.toPoint();
            if (!point.IsEmpty())
                marks.points.push_back({numbered(name, marks.points.size()), {point.getX(), point.getY()}});
            return;
        }
        case wkbLineString: {
            Polyline line;
            for (const OGRPoint& point : *geometry.toLineString()) line.push_back({point.getX(), point.getY()});
            if (line.size() >= 2) marks.lines.push_back({numbered(name, marks.lines.size()), std::move(line)});
            return;
        }
        case wkbPolygon:
        case wkbMultiPolygon:
            ++marks.polygons;
            return;
        case wkbMultiPoint:
        case wkbMultiLineString:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_marks(*part, name, marks);
            return;
        default:
            return;
    }
}

void transform_places(Marks& marks, const std::string& from, const std::string& to) {
    Bounds box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    const auto each = [&](const auto& visit) {
        for (NamedPoint& point : marks.points) visit(point.place);
        for (NamedLine& line : marks.lines)
            for (Point& place : line.line) visit(place);
    };
    each([&](const Point& p) {
        box = {std::min(box.west, p.x), std::min(box.south, p.y), std::max(box.east, p.x), std::max(box.north, p.y)};
    });
    if (box.west > box.east) return;
    marks.own_bounds = box;
    const CrsTransform transform(from, to, box);
    marks.transform = transform.info();
    each([&](Point& p) { p = transform(p); });
}

}  // namespace

Marks read_marks(const std::string& path, const std::string& target_crs_wkt, const Place& where) {
    const GdalSession session;
    const ReadingOnly reading;
    const VectorSource source = vector_source(path, where);
    TimeLimit limit(source.where);
    const auto error_of = [&](const std::string& what, const std::string& value, const std::string& remedy) {
        return vector_error(source, what, value, remedy);
    };
    const GDALDatasetUniquePtr dataset = open_vector(source);
    Marks marks;
    std::string crs;
    bool found = source.layer.empty();
    VertexCount vertices(source);
    for (OGRLayer* layer : dataset->GetLayers()) {
        if (!source.layer.empty() && source.layer != layer->GetName()) continue;
        found = true;
        if (crs.empty()) crs = declared_crs(*dataset, *layer, source);
        for (const auto& feature : *layer) {
            const OGRGeometry* geometry = feature->GetGeometryRef();
            limit.again();
            vertices.add(geometry);
            if (!geometry) continue;
            const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
            add_marks(*straight, name_of(*feature), marks);
        }
    }
    if (!found) throw error_of("the file has no such layer", source.layer, "Name one of its layers");
    require_sound(session, source);
    if (marks.points.empty() && marks.lines.empty() && marks.polygons == 0)
        throw error_of("the file contains no point and no line", "", "Draw at least one");
    marks.crs_wkt = crs;
    marks.crs_label = crs.empty() ? "none" : crs_name(crs);
    if (crs.empty() && !target_crs_wkt.empty()) {
        throw error_of("the file names no coordinate reference system", "",
                       crs_remedy(source) + ", or use terrain.crs = local throughout");
    }
    try {
        transform_places(marks, target_crs_wkt.empty() ? "" : crs, target_crs_wkt);
    } catch (const Error& error) {
        throw error_of(error.problems().front().what, error.problems().front().value, error.problems().front().remedy);
    }
    return marks;
}

}  // namespace frana::gis
