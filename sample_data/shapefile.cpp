// SPDX-License-Identifier: Apache-2.0
#include "sample_data/shapefile.h"

#include <cpl_string.h>
#include <ogrsf_frmts.h>

#include "core/error.h"
#include "gis/access/gdal_session.h"

namespace frana::sample {

void write_shapefile(const std::string& path, int epsg, const Ring& outline, const std::string& name) {
    const gis::GdalSession session;
    bool good = false;
    {
        OGRSpatialReference crs;
        crs.importFromEPSG(epsg);
        crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("ESRI Shapefile");
        const GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        CPLStringList options;
        options.SetNameValue("DBF_DATE_LAST_UPDATE", "2002-12-01");
        options.SetNameValue("ENCODING", "UTF-8");
        OGRLayer* layer = dataset ? dataset->CreateLayer("outline", &crs, wkbPolygon, options.List()) : nullptr;
        OGRFieldDefn field("name", OFTString);
        field.SetWidth(40);
        if (layer && layer->CreateField(&field) == OGRERR_NONE) {
            OGRFeature feature(layer->GetLayerDefn());
            OGRLinearRing ring;
            for (const Point& point : outline) ring.addPoint(point.x, point.y);
            ring.closeRings();
            OGRPolygon polygon;
            polygon.addRing(&ring);
            feature.SetGeometry(&polygon);
            feature.SetField("name", name.c_str());
            good = layer->CreateFeature(&feature) == OGRERR_NONE;
        }
    }
    if (!good || session.failed()) {
        throw Error(ErrorKind::environment, Problem{"the shapefile cannot be written: " + session.last_message(), path,
                                                    "", "", "Check that the folder exists and may be written"});
    }
}

}  // namespace frana::sample
