// SPDX-License-Identifier: Apache-2.0
#include "gis/lines_in.h"

#include <cpl_vsi.h>
#include <ogrsf_frmts.h>

#include <memory>

#include "core/error.h"
#include "gis/crs.h"
#include "gis/gdal_session.h"

namespace frana::gis {
namespace {

Error fault(const std::string& where, const std::string& what, const std::string& value,
            const std::string& remedy) {
    return {ErrorKind::input, Problem{what, where, value, "", remedy}};
}

/// The line of a feature; parts that join are put together.
Polyline line_of(const OGRFeature& feature, const std::string& where) {
    const std::string name = "feature " + std::to_string(feature.GetFID());
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) throw fault(where, name + " has no geometry", "", "Draw a line");
    std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
    if (wkbFlatten(straight->getGeometryType()) == wkbMultiLineString) {
        straight.reset(OGRGeometryFactory::forceToLineString(straight.release()));
    }
    if (wkbFlatten(straight->getGeometryType()) != wkbLineString) {
        const bool parts = wkbFlatten(straight->getGeometryType()) == wkbMultiLineString;
        throw fault(where, name + (parts ? " has parts that do not join" : " is no line"),
                    straight->getGeometryName(), "Draw one line per inflow");
    }
    Polyline line;
    for (const OGRPoint& point : *straight->toLineString()) line.push_back({point.getX(), point.getY()});
    return line;
}

}  // namespace

LineInputLayer read_lines(const std::string& path, const std::string& target_crs_wkt, const std::string& where) {
    const GdalSession session;
    constexpr const char* k_mark = "|layer=";
    const std::size_t mark = path.find(k_mark);
    const std::string file = path.substr(0, mark);
    const std::string place = where + ": " + path;
    VSIStatBufL status;
    if (VSIStatL(file.c_str(), &status) != 0)
        throw fault(place, "the file does not exist", "", "Check the path; it is relative to the scene file");
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (!dataset)
        throw fault(place, "the file is not a vector file that can be read: " + session.last_message(), "",
                    "Give lines in a shapefile, GeoPackage, GeoJSON or another file that OGR reads");
    OGRLayer* layer = nullptr;
    if (mark != std::string::npos) {
        layer = dataset->GetLayerByName(path.substr(mark + std::string(k_mark).size()).c_str());
        if (!layer) throw fault(place, "the file has no such layer", "", "Check the name after |layer=");
    } else {
        if (dataset->GetLayerCount() != 1)
            throw fault(place, "the file does not hold just one layer", std::to_string(dataset->GetLayerCount()),
                        "Name one: FILE|layer=NAME");
        layer = dataset->GetLayer(0);
    }
    const std::string crs = layer_crs(layer->GetSpatialRef());
    if (crs.empty() && !target_crs_wkt.empty())
        throw fault(place, "the file names no coordinate reference system", "",
                    "Assign one (ogr2ogr -a_srs EPSG:...), or use terrain.crs = local throughout");
    LineInputLayer read;
    read.crs_label = crs.empty() ? "none" : crs_name(crs);
    layer->ResetReading();
    for (const auto& from : *layer) {
        LineInput feature{line_of(*from, place), {}};
        for (int i = 0; i < from->GetFieldCount(); ++i) {
            if (from->IsFieldSetAndNotNull(i))
                feature.texts[from->GetFieldDefnRef(i)->GetNameRef()] = from->GetFieldAsString(i);
        }
        read.features.push_back(std::move(feature));
    }
    if (read.features.empty()) throw fault(place, "the layer is empty", layer->GetName(), "Draw a line");
    const CrsTransform transform(target_crs_wkt.empty() ? "" : crs, target_crs_wkt);
    read.transform = transform.info();
    for (LineInput& feature : read.features) {
        for (Point& point : feature.line) point = transform(point);
    }
    return read;
}

}  // namespace frana::gis
