// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/geopackage.h"

#include <ogrsf_frmts.h>

#include "core/error.h"
#include "core/file_aside.h"
#include "gis/access/gdal_session.h"

namespace frana::gis {
namespace {

[[noreturn]] void refuse(const std::string& path, const GdalSession& session) {
    const std::string message = session.last_message();
    throw Error(ErrorKind::environment,
                Problem{"the vector file cannot be written" + (message.empty() ? "" : ": " + message), path, "", "",
                        "Check that the folder exists, may be written and has free space"});
}

}  // namespace

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
        if (!dataset || !write_layers(*dataset, &crs)) refuse(gpkg_path, session);
        dataset->FlushCache();
    }
    // Closing writes the last bytes and reports errors only through the error handler.
    if (session.failed()) refuse(gpkg_path, session);
    file.sync_to_disk();
    file.rename_into_place();
}

}  // namespace frana::gis
