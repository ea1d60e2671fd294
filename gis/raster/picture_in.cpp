// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/picture_in.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal.h>
#include <gdal_utils.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/shortest_text.h"
#include "gis/access/access_problem.h"
#include "gis/access/gdal_session.h"
#include "gis/access/local_files.h"
#include "gis/access/memory_dataset.h"
#include "gis/access/network.h"
#include "gis/access/time_limit.h"
#include "gis/raster/picture_colours.h"

namespace frana::gis {
namespace {

GdalDataset opened(const std::string& path, const std::string& crs_wkt, const std::string& where) {
    const GdalSession session;
    const auto refuse = [&](const std::string& what, const std::string& value, const std::string& limit,
                            const std::string& remedy) {
        return Error(ErrorKind::input, Problem{what, where + ": " + path, value, limit, remedy});
    };
    (void)pop_access_problem();
    if (const auto remedy = network_remedy(path)) throw refuse("the file is read over the network", "", "", *remedy);
    GdalDataset dataset(GDALOpen(path.c_str(), GA_ReadOnly));
    if (const auto cause = pop_access_problem()) throw refuse(cause->what, cause->value, "", cause->remedy);
    if (!dataset) {
        throw refuse(
            std::filesystem::exists(path) ? "the file is not a raster that can be read" : "the file does not exist", "",
            "", "Name an orthophoto or a topographic map");
    }
    std::array<double, 6> geo{};
    if (GDALGetGeoTransform(dataset.get(), geo.data()) != CE_None) {
        throw refuse("the picture is not georeferenced", "", "", "Give a GeoTIFF, or a picture with a world file");
    }
    const int bands = GDALGetRasterCount(dataset.get());
    if (bands < 1) throw refuse("the picture has no band", "", "", "");
    const GDALDataType type = GDALGetRasterDataType(GDALGetRasterBand(dataset.get(), 1));
    if (type != GDT_Byte) {
        throw refuse("the picture's values are not bytes", GDALGetDataTypeName(type), "Byte",
                     "Convert it: gdal_translate -ot Byte -scale");
    }
    if (!crs_wkt.empty() && GDALGetSpatialRef(dataset.get()) == nullptr) {
        throw refuse("the picture names no coordinate reference system", "", "",
                     "Assign one: gdal_edit.py -a_srs EPSG:... FILE");
    }
    return dataset;
}

/// Returns a checksum of the blocks of a file, of a large one of some, including the first and the last; none: they
/// cannot be read.
std::optional<std::uint32_t> content_of(GDALDatasetH picture) {
    constexpr std::int64_t k_most_blocks = 400;
    GDALRasterBandH band = GDALGetRasterBand(picture, 1);
    int width = 0, height = 0;
    GDALGetBlockSize(band, &width, &height);
    const auto pieces = [](int whole, int part) { return (whole + part - 1) / part; };
    const std::int64_t across = pieces(GDALGetRasterXSize(picture), width),
                       count = across * pieces(GDALGetRasterYSize(picture), height);
    const std::int64_t n_read = std::min(count, k_most_blocks);
    const int bands = GDALGetRasterCount(picture);
    std::vector<std::uint8_t> values;
    uLong sum = 0;
    for (std::int64_t i = 0; i < n_read; ++i) {
        const std::int64_t block = n_read == 1 ? 0 : i * (count - 1) / (n_read - 1);
        const int column = static_cast<int>(block % across) * width, row = static_cast<int>(block / across) * height;
        const int wide = std::min(width, GDALGetRasterXSize(picture) - column),
                  high = std::min(height, GDALGetRasterYSize(picture) - row);
        values.resize(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high) *
                      static_cast<std::size_t>(bands));
        if (GDALDatasetRasterIO(picture, GF_Read, column, row, wide, high, values.data(), wide, high, GDT_Byte, bands,
                                nullptr, 0, 0, 0) != CE_None)
            return std::nullopt;
        sum = crc32_z(sum, values.data(), values.size());
    }
    return static_cast<std::uint32_t>(sum);
}

}  // namespace

std::uint32_t check_picture(const std::string& path, const std::string& crs_wkt, const std::string& where) {
    const GdalSession session;
    const ReadingOnly reading;
    const TimeLimit limit(where + ": " + path);
    const GdalDataset picture = opened(path, crs_wkt, where);
    const std::optional<std::uint32_t> content = content_of(picture.get());
    if (content && !session.failed()) return *content;
    throw Error(ErrorKind::input, Problem{"the picture is damaged: " + session.last_message(), where + ": " + path, "",
                                          "", "Copy the file again"});
}

std::vector<std::uint8_t> warp_picture(const std::string& path, const std::string& crs_wkt, const Bounds& box,
                                       int width, int height) {
    const GdalSession session;
    const ReadingOnly reading;
    const GdalDataset source = opened(path, crs_wkt, path);
    const GdalDataset coloured = in_colours(source.get());
    GdalDataset warped;
    if (coloured) {
        CPLStringList words;
        for (const std::string& word :
             {std::string("-of"), std::string("MEM"), std::string("-te"), shortest_text(box.west),
              shortest_text(box.south), shortest_text(box.east), shortest_text(box.north), std::string("-ts"),
              std::to_string(width), std::to_string(height), std::string("-r"), std::string("bilinear"),
              std::string("-dstalpha"), std::string("-q")}) {
            words.AddString(word.c_str());
        }
        if (!crs_wkt.empty()) {
            words.AddString("-t_srs");
            words.AddString(crs_wkt.c_str());
        }
        GDALWarpAppOptions* options = GDALWarpAppOptionsNew(words.List(), nullptr);
        GDALDatasetH from = coloured.get();
        int usage_error = 0;
        warped.reset(GDALWarp("", nullptr, 1, &from, options, &usage_error));
        GDALWarpAppOptionsFree(options);
    }
    std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const bool read = warped && GDALGetRasterCount(warped.get()) == 4 &&
                      GDALDatasetRasterIO(warped.get(), GF_Read, 0, 0, width, height, rgba.data(), width, height,
                                          GDT_Byte, 4, nullptr, 4, 4 * width, 1) == CE_None;
    if (!read) {
        throw Error(ErrorKind::input, Problem{"the picture cannot be warped onto the map", path, session.last_message(),
                                              "", "Warp it beforehand with gdalwarp"});
    }
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        for (std::size_t k = 0; k < 3; ++k)
            rgba[i + k] = static_cast<std::uint8_t>((rgba[i + k] * rgba[i + 3] + 127) / 255);
    }
    return rgba;
}

}  // namespace frana::gis
