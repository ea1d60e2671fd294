// SPDX-License-Identifier: Apache-2.0
#include "sample_data/samples.h"

#include <cpl_string.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "core/error.h"
#include "core/geometry.h"
#include "core/raster.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_out.h"
#include "sample_data/bindo_terrain.h"

namespace frana::sample {
namespace {

/// Writes a shapefile of one polygon with a text attribute "name", in a CRS given by its EPSG code. The date in its
/// attribute table is fixed, so that writing it again gives the same bytes. Throws Error(environment).
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

Raster sampled(const GridSpec& grid, const std::function<double(Point)>& value) {
    Raster raster(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const Point local = grid.local_from_map(grid.cell_centre(row, column));
            raster.at(row, column) = std::round(value(local) * 100) / 100;
        }
    }
    return raster;
}

/// Converts local metres to another CRS, rounded to `parts` of its unit.
Ring moved(const Ring& local, const GridSpec& grid, const std::string& crs_wkt, double parts) {
    const gis::CrsTransform transform(grid.crs_wkt, crs_wkt, grid.bounds());
    Ring out;
    for (const Point& point : local) {
        const Point to = transform(grid.map_from_local(point));
        out.push_back({std::round(to.x * parts) / parts, std::round(to.y * parts) / parts});
    }
    return out;
}

}  // namespace

void write_bindo_sample(const std::string& folder) {
    const auto file = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
    GridSpec grid = bindo_grid();
    grid.crs_wkt = gis::crs_from_user("EPSG:32632", "");
    const std::map<std::string, std::string> origin{{"ORIGIN", "Synthetic: made by frana's sample generator"}};
    gis::write_geotiff(file("dtm.tif"), sampled(grid, bindo_height),
                       {"dtm", "Synthetic terrain before the failure", "m", origin});
    gis::write_geotiff(file("thickness.tif"), sampled(grid, release_thickness),
                       {"thickness", "Synthetic thickness of the failing mass, vertical", "m", origin});
    write_shapefile(file("perimeter.shp"), 4326, moved(release_rim(), grid, gis::crs_from_user("EPSG:4326", ""), 1e9),
                    "failing mass");
    write_shapefile(file("scar.shp"), 3003, moved(scar_outline(), grid, gis::crs_from_user("EPSG:3003", ""), 1e3),
                    "outline after the event");
}

}  // namespace frana::sample
