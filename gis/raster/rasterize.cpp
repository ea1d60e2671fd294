// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/rasterize.h"

#include <gdal_alg.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/access/memory_dataset.h"
#include "gis/raster/footprint.h"
#include "gis/vector/polygon_geometry.h"

namespace frana::gis {
namespace {

Error error_of(const std::string& what, const GdalSession& session) {
    return {ErrorKind::input, Problem{what + ": " + session.last_message(), "", "", "", ""}};
}

GdalDataset on_grid(Raster& raster) {
    const GridSpec& g = raster.grid;
    GdalDataset dataset = wrap_values(raster.values.data(), static_cast<int>(g.columns), static_cast<int>(g.rows));
    double geo[6] = {g.west, g.cell_size, 0, g.north, 0, -g.cell_size};
    GDALSetGeoTransform(dataset.get(), geo);
    return dataset;
}

/// A vector layer in memory for GDAL to write to; the dataset owns it.
struct MemoryLayer {
    GDALDatasetUniquePtr dataset;
    OGRLayer* layer = nullptr;
};

MemoryLayer memory_layer(OGRwkbGeometryType type, const char* number) {
    MemoryLayer made;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("Memory");
    made.dataset.reset(driver->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    made.layer = made.dataset->CreateLayer("shapes", nullptr, type, nullptr);
    OGRFieldDefn field(number, OFTReal);
    made.layer->CreateField(&field);
    return made;
}

}  // namespace

Raster coverage(const MultiPolygon& polygons, const GridSpec& grid) {
    const GdalSession session;
    Raster mask(grid, 0.0);
    if (polygons.empty() || grid.cell_count() == 0) return mask;
    if (mask.values.is_tiled()) {
        for (const Polygon& polygon : polygons)
            visit_cells({polygon}, grid, Cover::centres,
                        [&](std::int64_t row, std::int64_t column) { mask.at(row, column) = 1; });
        return mask;
    }
    const GdalDataset dataset = on_grid(mask);
    std::vector<std::unique_ptr<OGRPolygon>> owned;
    std::vector<OGRGeometryH> handles;
    for (const Polygon& polygon : polygons) {
        owned.push_back(to_ogr(polygon));
        handles.push_back(OGRGeometry::ToHandle(owned.back().get()));
    }
    int band = 1;
    const std::vector<double> ones(handles.size(), 1.0);
    if (GDALRasterizeGeometries(dataset.get(), 1, &band, static_cast<int>(handles.size()), handles.data(), nullptr,
                                nullptr, ones.data(), nullptr, nullptr, nullptr) != CE_None) {
        throw error_of("the outline cannot be rasterised", session);
    }
    GDALFlushCache(dataset.get());
    return mask;
}

MultiPolygon polygonise(const Raster& mask) {
    const GdalSession session;
    if (mask.values.is_tiled()) {
        MultiPolygon outlines;
        for (const CellWindow& window : mask.values.stored_windows(mask.grid.columns)) {
            Raster part = part_of(mask, window);
            static_cast<void>(part.values.dense());  // of any size
            const MultiPolygon more = polygonise(part);
            outlines.insert(outlines.end(), more.begin(), more.end());
        }
        return outlines;
    }
    Raster inside(mask.grid, 0.0);
    static_cast<void>(inside.values.dense());
    mask.values.for_each_stored([&](std::size_t cell, double value) {
        if (!std::isnan(value) && value != 0) inside.values[cell] = 1;
    });
    const GdalDataset dataset = on_grid(inside);
    GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
    const MemoryLayer shapes = memory_layer(wkbPolygon, "inside");
    // The band serves as its own mask: zeros are excluded.
    if (GDALPolygonize(band, band, OGRLayer::ToHandle(shapes.layer), 0, nullptr, nullptr, nullptr) != CE_None) {
        throw error_of("the area's outline cannot be traced", session);
    }
    MultiPolygon outlines;
    for (const auto& feature : *shapes.layer) {
        const OGRGeometry* geometry = feature->GetGeometryRef();
        if (!geometry || wkbFlatten(geometry->getGeometryType()) != wkbPolygon) continue;
        if (auto polygon = from_ogr(*geometry->toPolygon())) outlines.push_back(std::move(*polygon));
    }
    return outlines;
}

}  // namespace frana::gis
