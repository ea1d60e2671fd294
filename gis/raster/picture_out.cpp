// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/picture_out.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <array>
#include <cstdio>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/access/gdal_session.h"
#include "gis/access/local_files.h"
#include "gis/access/memory_dataset.h"

namespace frana::gis {
namespace {

GdalDataset in_memory(const PicturePixels& picture, const std::string& path, const GdalSession& session) {
    GdalDataset dataset(
        GDALCreate(GDALGetDriverByName("MEM"), "", picture.width, picture.height, 3, GDT_Byte, nullptr));
    constexpr std::array<GDALColorInterp, 3> k_bands{GCI_RedBand, GCI_GreenBand, GCI_BlueBand};
    for (int k = 0; k < 3; ++k)
        GDALSetRasterColorInterpretation(GDALGetRasterBand(dataset.get(), k + 1), k_bands[static_cast<std::size_t>(k)]);
    if (GDALDatasetRasterIO(dataset.get(), GF_Write, 0, 0, picture.width, picture.height,
                            const_cast<std::uint8_t*>(picture.rgb.data()), picture.width, picture.height, GDT_Byte, 3,
                            nullptr, 3, 3 * picture.width, 1) != CE_None) {
        session.refuse_written("the picture", path);
    }
    return dataset;
}

void set_place(GDALDatasetH dataset, const Bounds& box, const std::string& crs_wkt) {
    std::array<double, 6> geo{box.west, box.width() / GDALGetRasterXSize(dataset),  0, box.north,
                              0,        -box.height() / GDALGetRasterYSize(dataset)};
    GDALSetGeoTransform(dataset, geo.data());
    if (crs_wkt.empty()) return;
    OGRSpatialReferenceH crs = OSRNewSpatialReference(crs_wkt.c_str());
    OSRSetAxisMappingStrategy(crs, OAMS_TRADITIONAL_GIS_ORDER);
    GDALSetSpatialRef(dataset, crs);
    OSRDestroySpatialReference(crs);
}

void write(const std::string& path, GDALDatasetH dataset, const char* driver, const CPLStringList& options,
           const GdalSession& session) {
    const NoSideFiles quiet;
    const MemoryFolder memory;
    {
        const GdalDataset written(GDALCreateCopy(GDALGetDriverByName(driver), memory.place_of(path).c_str(), dataset,
                                                 FALSE, options.List(), nullptr, nullptr));
        if (!written) session.refuse_written("the picture", path);
    }
    // Closing writes the last bytes and reports errors only through the error handler.
    if (session.failed()) session.refuse_written("the picture", path);
    memory.write_to_disk(path, Sync::no);
}

std::string neat_line(const Bounds& map) {
    std::array<char, 320> text{};
    std::snprintf(text.data(), text.size(), "POLYGON ((%.3f %.3f,%.3f %.3f,%.3f %.3f,%.3f %.3f,%.3f %.3f))", map.west,
                  map.north, map.east, map.north, map.east, map.south, map.west, map.south, map.west, map.north);
    return text.data();
}

}  // namespace

void write_picture_geotiff(const std::string& path, const PicturePixels& picture, const Bounds& box,
                           const std::string& crs_wkt, const std::map<std::string, std::string>& metadata) {
    const GdalSession session;
    const GdalDataset dataset = in_memory(picture, path, session);
    set_place(dataset.get(), box, crs_wkt);
    for (const auto& [key, value] : metadata)
        GDALSetMetadataItem(dataset.get(), key.c_str(), valid_utf8(value).c_str(), nullptr);
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "STANDARD");
    options.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
    write(path, dataset.get(), "COG", options, session);
}

bool is_drawn_geotiff(const std::string& path) {
    const GdalSession session;
    const GdalDataset dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!dataset || GDALGetRasterCount(dataset.get()) != 3) return false;
    for (const char* key : {"TITLE", "SOURCE", "ATTRIBUTION"})
        if (GDALGetMetadataItem(dataset.get(), key, nullptr) == nullptr) return false;
    return GDALGetRasterDataType(GDALGetRasterBand(dataset.get(), 1)) == GDT_Byte;
}

void write_pdf(const std::string& path, const std::string& bytes, const std::optional<PicturePlace>& place) {
    if (!place || place->crs_wkt.empty()) {
        write_file(path, bytes);
        return;
    }
    const GdalSession session;
    const NoSideFiles quiet;
    const MemoryFolder memory;
    const std::string copy = memory.place_of(path);
    VSILFILE* file = VSIFOpenL(copy.c_str(), "wb");
    if (file == nullptr || VSIFWriteL(bytes.data(), 1, bytes.size(), file) != bytes.size())
        session.refuse_written("the picture", path);
    VSIFCloseL(file);
    {
        // GDAL appends the place to the file and leaves its page as it is.
        const ThreadOption encoding("GDAL_PDF_GEO_ENCODING", "ISO32000");
        const GdalDataset page(GDALOpenEx(copy.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE, nullptr, nullptr, nullptr));
        if (!page) session.refuse_written("the picture", path);
        set_place(page.get(), place->page, place->crs_wkt);
        GDALSetMetadataItem(page.get(), "NEATLINE", neat_line(place->map).c_str(), nullptr);
    }
    if (session.failed()) session.refuse_written("the picture", path);
    memory.write_to_disk(path, Sync::no);
}

}  // namespace frana::gis
