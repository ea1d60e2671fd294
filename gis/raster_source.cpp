// SPDX-License-Identifier: Apache-2.0
#include "gis/raster_source.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/json.h"
#include "gis/crs.h"
#include "gis/gdal_session.h"

namespace frana::gis {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& where, const std::string& path,
                         const std::string& remedy) {
    throw Error(ErrorKind::input, Problem{what, where, path, "", remedy});
}

GdalDataset open(const std::string& path, const std::string& where) {
    const GdalSession session;
    GdalDataset dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   nullptr, nullptr, nullptr));
    if (dataset) return dataset;
    VSIStatBufL status;
    if (VSIStatL(path.c_str(), &status) != 0) {
        refuse("the file does not exist", where, path, "Check the path; it is relative to the scene file");
    }
    refuse("the file is not a raster that can be read: " + session.last_message(), where, path,
           "Give a GeoTIFF, an ASCII grid or another raster that GDAL reads");
}

std::string crs_of(GDALDatasetH dataset) {
    OGRSpatialReferenceH crs = GDALGetSpatialRef(dataset);
    if (!crs) return {};
    const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
    char* text = nullptr;
    const bool good = OSRExportToWktEx(crs, &text, options) == OGRERR_NONE;
    std::string wkt = good && text ? text : "";
    CPLFree(text);
    // An engineering CRS ("local") places nothing on the Earth.
    const bool on_earth = OSRIsProjected(crs) || OSRIsGeographic(crs) || OSRIsCompound(crs);
    return on_earth ? wkt : std::string();
}

Point at(const GeoTransform& g, Point p) noexcept {
    return {g[0] + p.x * g[1] + p.y * g[2], g[3] + p.x * g[4] + p.y * g[5]};
}

Bounds bounds_of(const GeoTransform& g, double columns, double rows) {
    const Point corners[] = {at(g, {0, 0}), at(g, {columns, 0}), at(g, {0, rows}), at(g, {columns, rows})};
    Bounds b{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
    for (const Point& corner : corners) {
        b.west = std::min(b.west, corner.x);
        b.east = std::max(b.east, corner.x);
        b.south = std::min(b.south, corner.y);
        b.north = std::max(b.north, corner.y);
    }
    return b;
}

}  // namespace

RasterSource::RasterSource(const std::string& path, const std::string& where, bool accept_colour_table)
    : dataset_(open(path, where)) {
    const GdalSession session;
    GDALDatasetH dataset = dataset_.get();
    if (GDALGetRasterCount(dataset) < 1) {
        refuse("the raster has no band", where, path,
               "Where a file holds several rasters, name one as GDAL does");
    }
    band_ = GDALGetRasterBand(dataset, 1);
    const GDALDataType type = GDALGetRasterDataType(band_);
    const GDALColorInterp colour = GDALGetRasterColorInterpretation(band_);
    const bool picture = colour == GCI_RedBand || (colour == GCI_PaletteIndex && !accept_colour_table);
    if (GDALDataTypeIsComplex(type) || picture) {
        refuse("the raster is a picture or holds complex numbers, not one number per cell", where, path,
               "Give the raster of values itself");
    }
    if (GDALGetGeoTransform(dataset, geo_.data()) != CE_None ||
        !GDALInvGeoTransform(geo_.data(), inverse_.data())) {
        refuse("the raster does not say where it lies", where, path,
               "Add a world file or a geotransform (gdal_translate -a_ullr)");
    }
    info_.path = path;
    info_.crs_wkt = crs_of(dataset);
    info_.crs_label = info_.crs_wkt.empty() ? "none" : crs_name(info_.crs_wkt);
    info_.driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
    info_.data_type = GDALGetDataTypeName(type);
    info_.columns = GDALGetRasterXSize(dataset);
    info_.rows = GDALGetRasterYSize(dataset);
    info_.bounds = bounds_of(geo_, static_cast<double>(info_.columns), static_cast<double>(info_.rows));
    info_.cell_x = std::hypot(geo_[1], geo_[4]);
    info_.cell_y = std::hypot(geo_[2], geo_[5]);
    info_.rotated = geo_[2] != 0 || geo_[4] != 0;
    int has = 0;
    info_.nodata = GDALGetRasterNoDataValue(band_, &has);
    info_.has_nodata = has != 0;
    scale_ = GDALGetRasterScale(band_, &has);
    if (!has || scale_ == 0) scale_ = 1;
    offset_ = GDALGetRasterOffset(band_, &has);
    if (!has) offset_ = 0;
    unit_ = vertical_unit_of(GDALGetRasterUnitType(band_), info_.crs_wkt);
    info_.vertical_unit = unit_.name;
    info_.vertical_scale_to_metres = unit_.metres;
}

Point RasterSource::map_from_cell(Point cell) const noexcept {
    return at(geo_, cell);
}

Point RasterSource::cell_from_map(Point map) const noexcept {
    return at(inverse_, map);
}

std::vector<double> RasterSource::read(const Window& w, double unit) const {
    const GdalSession session;
    const std::size_t count = static_cast<std::size_t>(w.columns) * static_cast<std::size_t>(w.rows);
    std::vector<double> values(count);
    std::vector<std::uint8_t> valid(count);
    const auto fetch = [&](GDALRasterBandH band, void* into, GDALDataType type) {
        return GDALRasterIO(band, GF_Read, w.column, w.row, w.columns, w.rows, into, w.columns, w.rows, type,
                            0, 0);
    };
    if (fetch(band_, values.data(), GDT_Float64) != CE_None ||
        fetch(GDALGetMaskBand(band_), valid.data(), GDT_Byte) != CE_None) {
        refuse("the raster is damaged: " + session.last_message(), info_.path, "", "Copy the file anew");
    }
    for (std::size_t i = 0; i < count; ++i) {
        const bool good = valid[i] != 0 && std::isfinite(values[i]);
        values[i] = good ? (values[i] * scale_ + offset_) * unit : k_no_data;
    }
    return values;
}

std::string RasterSource::suspicion(const std::vector<double>& values, double unit) const {
    for (const double customary :
         {-9999.0, -99999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1e32, 1e20}) {
        const double as_read = (customary * scale_ + offset_) * unit;
        const auto n = std::count(values.begin(), values.end(), as_read);
        if (n > 0) {
            return info_.path + ": " + std::to_string(n) + " cells hold " + shortest_text(customary) +
                   ", which the file does not declare as no data; they were read as values. If they are no "
                   "data, "
                   "declare it: gdal_edit.py -a_nodata " +
                   shortest_text(customary) + " FILE";
        }
    }
    return {};
}

RasterInfo inspect_raster(const std::string& path, const std::string& where) {
    return RasterSource(path, where).info();
}

}  // namespace frana::gis
