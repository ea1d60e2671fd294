// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/footprint.h"

#include <gdal_alg.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_source.h"
#include "gis/vector/outline_check.h"

namespace frana::gis {
namespace {

/// The part of a grid around an outline, and its first cell.
struct OutlineWindow {
    GridSpec grid;
    std::int64_t row = 0, column = 0;
};

OutlineWindow window_round(const MultiPolygon& outline, const GridSpec& grid) {
    const Bounds box = bounds(outline);
    const auto cell = [&](double distance, std::int64_t count, std::int64_t beyond) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(distance / grid.cell_size)) + beyond, 0,
                                        count);
    };
    OutlineWindow window{grid, cell(grid.north - box.north, grid.rows, -1),
                         cell(box.west - grid.west, grid.columns, -1)};
    window.grid.rows = cell(grid.north - box.south, grid.rows, 2) - window.row;
    window.grid.columns = cell(box.east - grid.west, grid.columns, 2) - window.column;
    window.grid.north -= static_cast<double>(window.row) * grid.cell_size;
    window.grid.west += static_cast<double>(window.column) * grid.cell_size;
    return window;
}

/// Whether cells selected by their centres might leave gaps: shrunk by half a cell's diagonal the polygon vanishes or
/// is divided.
bool is_thin(const OGRPolygon& polygon, double cell_size) {
    const double half_diagonal = cell_size * std::numbers::sqrt2 / 2;
    const std::unique_ptr<OGRGeometry> core(polygon.Buffer(-half_diagonal));
    return !core || core->IsEmpty() || wkbFlatten(core->getGeometryType()) != wkbPolygon;
}

}  // namespace

bool visit_cells(const MultiPolygon& outline, const GridSpec& grid, Cover cover,
                 const std::function<void(std::int64_t row, std::int64_t column)>& visit) {
    const GdalSession session;
    const char* const touched[] = {"ALL_TOUCHED=TRUE", nullptr};
    bool any_thin = false;
    std::vector<std::int64_t> cells;
    // Each polygon in its own window: parts of an outline may lie kilometres apart.
    for (const Polygon& part : outline) {
        const OutlineWindow window = window_round({part}, grid);
        if (window.grid.rows <= 0 || window.grid.columns <= 0) continue;
        const int columns = static_cast<int>(window.grid.columns), rows = static_cast<int>(window.grid.rows);
        const GdalDataset mask(
            GDALCreate(GDALGetDriverByName("MEM"), "", columns, rows, 1, GDT_Byte, nullptr));  // of zeros
        double geo[6] = {window.grid.west, grid.cell_size, 0, window.grid.north, 0, -grid.cell_size};
        const std::unique_ptr<OGRPolygon> polygon = to_ogr(part);
        const bool thin = cover == Cover::closed && is_thin(*polygon, grid.cell_size);
        any_thin = any_thin || thin;
        OGRGeometryH handle = OGRGeometry::ToHandle(polygon.get());
        int band = 1;
        double one = 1;
        bool done = mask && GDALSetGeoTransform(mask.get(), geo) == CE_None &&
                    GDALRasterizeGeometries(mask.get(), 1, &band, 1, &handle, nullptr, nullptr, &one,
                                            const_cast<char**>(thin ? touched : nullptr), nullptr, nullptr) == CE_None;
        std::vector<unsigned char> line(static_cast<std::size_t>(columns));
        for (int row = 0; done && row < rows; ++row) {
            done = GDALRasterIO(GDALGetRasterBand(mask.get(), 1), GF_Read, 0, row, columns, 1, line.data(), columns, 1,
                                GDT_Byte, 0, 0) == CE_None;
            for (int column = 0; done && column < columns; ++column)
                if (line[static_cast<std::size_t>(column)] != 0)
                    cells.push_back((window.row + row) * grid.columns + window.column + column);
        }
        if (!done)
            throw Error(ErrorKind::input,
                        Problem{"the outline cannot be rasterised: " + session.last_message(), "", "", "", ""});
    }
    if (outline.size() > 1) {
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    }
    for (const std::int64_t cell : cells) visit(cell / grid.columns, cell % grid.columns);
    return any_thin;
}

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
