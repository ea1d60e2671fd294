// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_source.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/error.h"
#include "core/raster.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

// Fraction of the value itself: ground does not fall by a quarter of its height from one cell to the next.
constexpr double k_wall = 0.25;

Sentence undeclared(const std::string& path, std::int64_t cells, double value) {
    return worded("{1}: {2} cells of {3}, not declared nodata: gdal_edit.py -a_nodata {3} FILE",
                  {path, std::to_string(cells), shortest_text(value)});
}

}  // namespace

GdalDataset wrap_values(double* values, int columns, int rows) {
    GdalDataset dataset(GDALCreate(GDALGetDriverByName("MEM"), "", columns, rows, 0, GDT_Float64, nullptr));
    CPLStringList options;
    char pointer[64] = {};
    CPLPrintPointer(pointer, values, sizeof(pointer) - 1);
    options.SetNameValue("DATAPOINTER", pointer);
    GDALAddBand(dataset.get(), GDT_Float64, options.List());
    GDALSetRasterNoDataValue(GDALGetRasterBand(dataset.get(), 1), k_no_data);
    return dataset;
}

void NodataSuspicion::examine(const std::vector<double>& values, int columns) {
    for (std::size_t i = 0; i < k_customary.size(); ++i)
        found_[i] += std::count(values.begin(), values.end(), k_customary[i]);
    const auto width = static_cast<std::size_t>(columns);
    for (Plateau& plateau : plateaus_) {
        const auto cells = std::count(values.begin(), values.end(), plateau.value);
        plateau.cells += cells;
        if (cells == 0) continue;
        const auto border = [&](std::size_t one, std::size_t other) {
            if (values[one] != plateau.value || values[other] == plateau.value || std::isnan(values[other])) return;
            ++plateau.borders;
            plateau.walls += std::abs(values[one] - values[other]) > k_wall * plateau.value;
        };
        for (std::size_t i = 0; i < values.size(); ++i) {
            if ((i + 1) % width != 0) {
                border(i, i + 1);
                border(i + 1, i);
            }
            if (i + width < values.size()) {
                border(i, i + width);
                border(i + width, i);
            }
        }
    }
    const auto jump = [&](std::size_t zero, std::size_t other) {
        if (values[zero] == 0 && values[other] != 0 && !std::isnan(values[other]))
            jumps_.push_back(static_cast<float>(std::abs(values[other])));
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        zeros_ += values[i] == 0;
        if ((i + 1) % width != 0) {
            jump(i, i + 1);
            jump(i + 1, i);
        }
        if (i + width < values.size()) {
            jump(i, i + width);
            jump(i + width, i);
        }
    }
}

std::int64_t NodataSuspicion::zero_rim(double steep) const {
    const auto n = std::count_if(jumps_.begin(), jumps_.end(), [&](float jump) { return jump > steep; });
    return 2 * static_cast<std::size_t>(n) > jumps_.size() ? zeros_ : 0;
}

std::optional<Sentence> NodataSuspicion::warning(const std::string& path) const {
    for (std::size_t i = 0; i < k_customary.size(); ++i) {
        if (found_[i] == 0) continue;
        return undeclared(path, found_[i], k_customary[i]);
    }
    for (const Plateau& plateau : plateaus_)
        if (plateau.cells > 0 && 2 * plateau.walls > plateau.borders)
            return undeclared(path, plateau.cells, plateau.value);
    return std::nullopt;
}

namespace {

[[noreturn]] void refuse(const std::string& what, const Place& where, const std::string& path,
                         const std::string& remedy) {
    throw Error(ErrorKind::input, Problem{what, where, path, "", remedy});
}

/// A refused access while the file was read is the cause of all errors that follow.
void throw_if_refused(const Place& where, const std::string& path) {
    if (const auto cause = pop_access_problem()) refuse(cause->what + ": " + cause->value, where, path, cause->remedy);
}

GdalDataset open(const std::string& path, const Place& where) {
    const GdalSession session;
    const ReadingOnly reading;
    (void)pop_access_problem();
    const TimeLimit limit(where + ": " + path);
    if (const auto remedy = network_remedy(path)) refuse("the file is read over the network", where, path, *remedy);
    GdalDataset dataset(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr));
    throw_if_refused(where, path);
    if (dataset) return dataset;
    VSIStatBufL status;
    if (VSIStatL(path.c_str(), &status) != 0) {
        refuse("the file does not exist", where, path,
               "Check the path: a scene's is relative to the scene file, an option's to the current folder");
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
    // An engineering CRS ("local") has no position on the Earth.
    const bool on_earth = OSRIsProjected(crs) || OSRIsGeographic(crs) || OSRIsCompound(crs);
    return on_earth ? wkt : std::string();
}

/// Returns the names by which the rasters inside a file (NetCDF, HDF, GeoPackage) are opened.
std::string subdatasets(GDALDatasetH dataset) {
    std::string names;
    char** items = GDALGetMetadata(dataset, "SUBDATASETS");
    for (int i = 1;; ++i) {
        const std::string key = "SUBDATASET_" + std::to_string(i) + "_NAME";
        const char* name = CSLFetchNameValue(items, key.c_str());
        if (!name) return names;
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
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

// A raster is read in blocks whose size the file sets. GDAL stores at least one of them, and for interleaved bands
// those of all bands, however small the requested part.
void refuse_huge_blocks(GDALDatasetH dataset, GDALRasterBandH band, const Place& where, const std::string& path) {
    constexpr double k_most_bytes = 1e9;
    int columns = 0, rows = 0;
    GDALGetBlockSize(band, &columns, &rows);
    const char* const interleaving = GDALGetMetadataItem(dataset, "INTERLEAVE", "IMAGE_STRUCTURE");
    const int bands = interleaving != nullptr && EQUAL(interleaving, "PIXEL") ? GDALGetRasterCount(dataset) : 1;
    const double bytes_per_cell = GDALGetDataTypeSizeBytes(GDALGetRasterDataType(band));
    if (bytes_per_cell * columns * rows * bands <= k_most_bytes) return;
    throw Error(
        ErrorKind::input,
        Problem{"the raster cannot be read in parts: one block of " + path + " takes too much memory", where,
                std::to_string(columns) + " x " + std::to_string(rows) + " cells, " + std::to_string(bands) + " bands",
                "up to 1 GB", "Convert it: gdal_translate -b 1 -co TILED=YES"});
}

}  // namespace

RasterSource::RasterSource(const std::string& path, const Place& where, bool accept_colour_table, int band)
    : where_(where), dataset_(open(path, where)) {
    const GdalSession session;
    const ReadingOnly reading;
    GDALDatasetH dataset = dataset_.get();
    if (GDALGetRasterCount(dataset) < band) {
        const std::string parts = subdatasets(dataset);
        refuse(parts.empty() ? "the raster has no band" : "the file contains several rasters", where, path,
               parts.empty() ? "Give a raster of elevations" : "Name one of them: " + parts);
    }
    band_ = GDALGetRasterBand(dataset, band);
    const GDALDataType type = GDALGetRasterDataType(band_);
    const GDALColorInterp colour = GDALGetRasterColorInterpretation(band_);
    const bool picture = colour == GCI_RedBand || (colour == GCI_PaletteIndex && !accept_colour_table);
    if (GDALDataTypeIsComplex(type) || picture) {
        refuse("the raster is a picture or has complex numbers, not one number per cell", where, path,
               "Give a raster of values");
    }
    refuse_huge_blocks(dataset, band_, where, path);
    const auto finite = [](double term) { return std::isfinite(term); };
    if (GDALGetGeoTransform(dataset, geo_.data()) != CE_None || !std::all_of(geo_.begin(), geo_.end(), finite) ||
        !GDALInvGeoTransform(geo_.data(), inverse_.data())) {
        refuse("the raster is not georeferenced", where, path,
               "Add a world file or a geotransform (gdal_translate -a_ullr)");
    }
    info_.path = path;
    info_.band_unit = GDALGetRasterUnitType(band_);
    info_ = with_crs(std::move(info_), crs_of(dataset));
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
    throw_if_refused(where, path);
}

Point RasterSource::map_from_cell(Point cell) const noexcept {
    return at(geo_, cell);
}

Point RasterSource::cell_from_map(Point map) const noexcept {
    return at(inverse_, map);
}

std::vector<double> RasterSource::read_stored(const Window& w, int columns, int rows) const {
    const GdalSession session;
    const ReadingOnly reading;
    const TimeLimit limit(where_ + ": " + info_.path);
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    std::vector<double> values(count);
    std::vector<std::uint8_t> valid(count);
    const auto fetch = [&](GDALRasterBandH band, void* into, GDALDataType type) {
        return GDALRasterIO(band, GF_Read, w.column, w.row, w.columns, w.rows, into, columns, rows, type, 0, 0);
    };
    const bool read = fetch(band_, values.data(), GDT_Float64) == CE_None &&
                      fetch(GDALGetMaskBand(band_), valid.data(), GDT_Byte) == CE_None;
    throw_if_refused(where_, info_.path);
    if (!read) {
        refuse("the raster is damaged: " + session.last_message(), where_, info_.path, "Copy the file again");
    }
    const auto declared = [&](double stored) {
        return declared_ && (stored == *declared_ || stored == static_cast<float>(*declared_));
    };
    for (std::size_t i = 0; i < count; ++i) {
        if (valid[i] == 0 || !std::isfinite(values[i]) || declared(values[i])) values[i] = k_no_data;
    }
    return values;
}

std::vector<double> RasterSource::read(const Window& window, double unit) const {
    std::vector<double> values = read_stored(window, window.columns, window.rows);
    suspicion_.examine(values, window.columns);
    for (double& value : values) value = (value * scale_ + offset_) * unit;
    return values;
}

std::vector<double> RasterSource::read_coarse(const Window& window, int columns, int rows, double unit) const {
    std::vector<double> values = read_stored(window, columns, rows);
    for (double& value : values) value = (value * scale_ + offset_) * unit;
    return values;
}

std::int64_t RasterSource::zero_rim(double steep, double unit) const {
    // Only if 0 is stored for an elevation of 0.
    return offset_ == 0 ? suspicion_.zero_rim(steep / (std::abs(scale_) * unit)) : 0;
}

RasterInfo with_crs(RasterInfo info, const std::string& crs_wkt) {
    info.crs_wkt = crs_wkt;
    info.crs_label = crs_wkt.empty() ? "none" : crs_name(crs_wkt);
    const VerticalUnit unit = vertical_unit_of(info.band_unit, crs_wkt);
    info.vertical_unit = unit.name;
    info.vertical_unit_stated = unit.stated;
    info.vertical_scale_to_metres = unit.metres;
    return info;
}

RasterInfo inspect_raster(const std::string& path, const Place& where) {
    return RasterSource(path, where).info();
}

bool RasterSource::holds_any(const Window& window) const noexcept {
    const int status = GDALGetDataCoverageStatus(band_, window.column, window.row, window.columns, window.rows,
                                                 GDAL_DATA_COVERAGE_STATUS_DATA, nullptr);
    return (status & GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED) != 0 || (status & GDAL_DATA_COVERAGE_STATUS_DATA) != 0;
}

}  // namespace frana::gis
