// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/geopackage.h"

#include <ogrsf_frmts.h>

#include "core/error.h"
#include "core/file_aside.h"
#include "gis/access/gdal_session.h"

namespace frana::gis {
namespace {}  // namespace

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

}  // namespace frana::gis
