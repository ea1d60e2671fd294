// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/lines_in.h"

#include <ogrsf_frmts.h>

#include <memory>

#include "gis/access/gdal_session.h"
#include "gis/access/remembered_reads.h"
#include "gis/access/time_limit.h"
#include "gis/crs/crs.h"
#include "gis/vector/declared_crs.h"
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

LineInputLayer read_lines_now(const std::string& path, const std::string& target_crs_wkt, const std::string& where) {
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

}  // namespace

LineInputLayer read_lines(const std::string& path, const std::string& target_crs_wkt, const std::string& where) {
    return remembered(
        "read_lines", [&] { return read_lines_now(path, target_crs_wkt, where); }, path, target_crs_wkt, where);
}

}  // namespace frana::gis
