// SPDX-License-Identifier: Apache-2.0
#include "gis/vector_out.h"

#include <ogrsf_frmts.h>

#include <set>

#include "core/error.h"
#include "core/file_aside.h"
#include "gis/gdal_session.h"
#include "gis/polygon_geometry.h"

namespace frana::gis {
namespace {

constexpr const char* k_area_field = "area_m2";

[[noreturn]] void refuse(const std::string& path, const GdalSession& session) {
    const std::string message = session.last_message();
    throw Error(ErrorKind::environment,
                Problem{"the outlines cannot be written" + (message.empty() ? "" : ": " + message), path, "",
                        "", "Check that the folder exists, may be written and has room"});
}

struct Fields {
    std::set<std::string> numbers, texts;
};

/// GeoPackage keeps these two names for itself; an attribute may not bear them.
bool reserved(const std::string& name) {
    return EQUAL(name.c_str(), "fid") || EQUAL(name.c_str(), "geom") || EQUAL(name.c_str(), k_area_field);
}

Fields fields_of(const OutlineLayer& layer) {
    Fields fields;
    for (const PolygonFeature& feature : layer.features) {
        for (const auto& [name, value] : feature.numbers) {
            if (!reserved(name)) fields.numbers.insert(name);
        }
        for (const auto& [name, value] : feature.texts) {
            if (!reserved(name)) fields.texts.insert(name);
        }
    }
    // A name that is a number in one feature and text in another is kept as a number where it is one.
    for (const std::string& name : fields.numbers) fields.texts.erase(name);
    return fields;
}

bool write_layer(GDALDataset& dataset, OGRSpatialReference* crs, const OutlineLayer& from) {
    OGRLayer* layer = dataset.CreateLayer(from.name.c_str(), crs, wkbMultiPolygon, nullptr);
    if (!layer) return false;
    const Fields fields = fields_of(from);
    const auto create = [&](const std::string& name, OGRFieldType type) {
        OGRFieldDefn field(name.c_str(), type);
        return layer->CreateField(&field) == OGRERR_NONE;
    };
    if (!create(k_area_field, OFTReal)) return false;
    for (const std::string& name : fields.numbers) {
        if (!create(name, OFTReal)) return false;
    }
    for (const std::string& name : fields.texts) {
        if (!create(name, OFTString)) return false;
    }
    for (const PolygonFeature& feature : from.features) {
        OGRFeature row(layer->GetLayerDefn());
        row.SetField(k_area_field, area(feature.parts));
        for (const auto& [name, value] : feature.numbers) {
            if (!reserved(name)) row.SetField(name.c_str(), value);
        }
        for (const auto& [name, value] : feature.texts) {
            if (fields.texts.count(name) > 0) row.SetField(name.c_str(), value.c_str());
        }
        row.SetGeometryDirectly(to_ogr(feature.parts).release());
        if (layer->CreateFeature(&row) != OGRERR_NONE) return false;
    }
    return true;
}

}  // namespace

void write_outlines(const std::string& gpkg_path, const std::string& crs_wkt,
                    const std::vector<OutlineLayer>& layers) {
    const GdalSession session;
    FileAside file(gpkg_path);
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
        if (!dataset) refuse(gpkg_path, session);
        for (const OutlineLayer& layer : layers) {
            if (!write_layer(*dataset, &crs, layer)) refuse(gpkg_path, session);
        }
        dataset->FlushCache();
    }
    // Closing writes the last bytes and reports only through the error handler.
    if (session.failed()) refuse(gpkg_path, session);
    file.rename_into_place();
}

}  // namespace frana::gis
