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

Raster coverage(const MultiPolygon& polygons, const GridSpec& grid) {
    Raster mask(grid, 0.0);
    visit_cells(polygons, grid, Cover::centres,
                [&](std::int64_t row, std::int64_t column) { mask.at(row, column) = 1; });
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
    const GridSpec& grid = inside.grid;
    const GdalDataset dataset =
        wrap_values(inside.values.data(), static_cast<int>(grid.columns), static_cast<int>(grid.rows));
    double geo[6] = {grid.west, grid.cell_size, 0, grid.north, 0, -grid.cell_size};
    GDALSetGeoTransform(dataset.get(), geo);
    GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
    const GDALDatasetUniquePtr memory(
        GetGDALDriverManager()->GetDriverByName("Memory")->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* const shapes = memory->CreateLayer("shapes", nullptr, wkbPolygon, nullptr);
    OGRFieldDefn field("inside", OFTReal);
    shapes->CreateField(&field);
    // The band serves as its own mask: zeros are excluded.
    if (GDALPolygonize(band, band, OGRLayer::ToHandle(shapes), 0, nullptr, nullptr, nullptr) != CE_None)
        throw Error(ErrorKind::input,
                    Problem{"the area's outline cannot be traced: " + session.last_message(), "", "", "", ""});
    MultiPolygon outlines;
    for (const auto& feature : *shapes) {
        const OGRGeometry* geometry = feature->GetGeometryRef();
        if (!geometry || wkbFlatten(geometry->getGeometryType()) != wkbPolygon) continue;
        if (auto polygon = from_ogr(*geometry->toPolygon())) outlines.push_back(std::move(*polygon));
    }
    return outlines;
}

}  // namespace frana::gis
