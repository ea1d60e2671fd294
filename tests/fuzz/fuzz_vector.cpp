// SPDX-License-Identifier: Apache-2.0
// Outlines. First byte: g GeoJSON, k GeoPackage, s shapefile (its .shp alone), z shapefile in a .shz.
#include <cpl_conv.h>

#include <cmath>

#include "gis/crs/crs.h"
#include "gis/vector/vector_in.h"
#include "harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace frana;
    CPLSetConfigOption("SHAPE_RESTORE_SHX", "YES");
    static const std::string utm = gis::crs_from_user("EPSG:32632", "");
    const fuzz::Input input = fuzz::split(data, size);
    const std::string ending = input.kind == 'k'   ? "gpkg"
                               : input.kind == 's' ? "shp"
                               : input.kind == 'z' ? "shz"
                                                   : "geojson";
    const fuzz::MemoryFile file("/vsimem/fuzz/outline." + ending, input.data, input.size);
    fuzz::refused_or_done([&] {
        const gis::PolygonLayer layer = gis::read_polygons(file.path(), utm, "release.perimeter");
        // Accepted outlines can be computed with.
        if (layer.features.empty()) __builtin_trap();
        for (const Feature& feature : layer.features) {
            for (const Polygon& polygon : feature.shape.areas) {
                if (polygon.outer.size() < 3 || !std::isfinite(area(polygon))) __builtin_trap();
            }
        }
    });
    return 0;
}
