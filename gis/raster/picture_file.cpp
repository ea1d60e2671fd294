// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/picture_file.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_utils.h>
#include <ogr_srs_api.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/geometry.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"
#include "gis/raster/raster_source.h"

namespace frana::gis {
namespace {

/// Returns red, green, blue and, if the file has it, opacity as a view of a file with a colour table or a single band,
/// which must stay open; nothing if GDAL fails.
GdalDataset in_colours(GDALDatasetH source) {
    GDALRasterBandH first = GDALGetRasterBand(source, 1);
    CPLStringList words;
    words.AddString("-of");
    words.AddString("VRT");
    if (GDALGetRasterColorTable(first) != nullptr) {
        words.AddString("-expand");
        words.AddString("rgba");
    } else {
        const int bands = GDALGetRasterCount(source);
        const bool grey = bands < 3;
        for (int k = 1; k <= 3; ++k) {
            words.AddString("-b");
            words.AddString(grey ? "1" : std::to_string(k).c_str());
        }
        const int last = grey ? 2 : 4;
        const bool alpha =
            bands >= last && GDALGetRasterColorInterpretation(GDALGetRasterBand(source, last)) == GCI_AlphaBand;
        if (alpha) {
            words.AddString("-b");
            words.AddString(std::to_string(last).c_str());
            words.AddString("-colorinterp_4");
            words.AddString("alpha");
        }
    }
    GDALTranslateOptions* options = GDALTranslateOptionsNew(words.List(), nullptr);
    int usage_error = 0;
    GdalDataset coloured(GDALTranslate("", source, options, &usage_error));
    GDALTranslateOptionsFree(options);
    return coloured;
}

struct Refusal {
    std::string path, where;

    [[nodiscard]] Error operator()(const std::string& what, const std::string& value = "",
                                   const std::string& limit = "",
                                   const std::string& remedy = "Name a PNG or JPEG file") const {
        return {ErrorKind::input, Problem{what, where + ": " + path, value, limit, remedy}};
    }
};

GdalDataset opened(const std::string& path, const Refusal& refuse) {
    (void)pop_access_problem();
    if (const auto remedy = network_remedy(path)) throw refuse("the file is read over the network", "", "", *remedy);
    constexpr std::array<const char*, 3> k_logo_drivers{"PNG", "JPEG", nullptr};
    GdalDataset file(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, k_logo_drivers.data(), nullptr, nullptr));
    if (const auto cause = pop_access_problem()) throw refuse(cause->what, cause->value, "", cause->remedy);
    if (!file)
        throw refuse(std::filesystem::exists(path) ? "the logo is neither a PNG nor a JPEG that can be read"
                                                   : "the file does not exist");
    const int width = GDALGetRasterXSize(file.get()), height = GDALGetRasterYSize(file.get());
    if (width > k_largest_logo || height > k_largest_logo) {
        throw refuse("the logo is too large", std::to_string(width) + " x " + std::to_string(height) + " pixels",
                     std::to_string(k_largest_logo) + " pixels per side", "Make it smaller");
    }
    if (GDALGetRasterDataType(GDALGetRasterBand(file.get(), 1)) != GDT_Byte)
        throw refuse("the logo has more than eight bits per colour", "", "", "Save it with eight bits per colour");
    return file;
}

}  // namespace

Logo read_logo(const std::string& path, const Place& where) {
    const GdalSession session;
    const ReadingOnly reading;
    const TimeLimit limit(where + ": " + path);
    const Refusal refuse{path, where};
    const GdalDataset file = opened(path, refuse);
    const GdalDataset coloured = in_colours(file.get());
    const int width = GDALGetRasterXSize(file.get()), height = GDALGetRasterYSize(file.get());
    const int bands = coloured ? GDALGetRasterCount(coloured.get()) : 0;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<std::uint8_t> rgba(4 * count, 255);
    if (bands < 3 ||
        GDALDatasetRasterIO(coloured.get(), GF_Read, 0, 0, width, height, rgba.data(), width, height, GDT_Byte, bands,
                            nullptr, 4, 4 * width, 1) != CE_None ||
        session.failed()) {
        throw refuse("the logo is damaged: " + session.last_message(), "", "", "Copy the file again");
    }
    Logo logo{width, height, std::vector<std::uint8_t>(3 * count), 0};
    for (std::size_t i = 0; i < count; ++i) {
        const int opacity = rgba[4 * i + 3];
        for (std::size_t k = 0; k < 3; ++k)
            logo.rgb[3 * i + k] =
                static_cast<std::uint8_t>((rgba[4 * i + k] * opacity + 255 * (255 - opacity) + 127) / 255);
    }
    logo.checksum = static_cast<std::uint32_t>(crc32_z(0, logo.rgb.data(), logo.rgb.size()));
    return logo;
}

namespace {

constexpr std::size_t k_small_png = 160'000;

/// From the best: a fraction of the greatest width, and JPEG's quality.
struct Grade {
    double width;
    int quality;
};
constexpr Grade k_grades[] = {{1, 90}, {1, 84}, {1, 76}, {0.75, 84}, {0.75, 74}, {0.5, 80}, {0.5, 65}, {0.3, 60}};

[[noreturn]] void refuse_picture(const std::string& path, const GdalSession& session) {
    const std::string message = session.last_message();
    throw Error(ErrorKind::environment,
                Problem{"the picture cannot be put into a page" + (message.empty() ? "" : ": " + one_line(message)),
                        path, "", "", "Draw it again with frana render"});
}

GdalDataset open_picture(const std::string& path, const GdalSession& session) {
    const char* const drivers[] = {"PNG", nullptr};
    GdalDataset picture(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, nullptr));
    if (!picture || GDALGetRasterCount(picture.get()) < 3) refuse_picture(path, session);
    return picture;
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the picture, narrower if need be, as JPEG.
PagePicture as_jpeg(GDALDatasetH picture, int width, int quality, const std::string& path, const GdalSession& session) {
    const int columns = GDALGetRasterXSize(picture), rows = GDALGetRasterYSize(picture);
    const int height = std::max(1, static_cast<int>(static_cast<double>(rows) * width / columns + 0.5));
    std::vector<std::uint8_t> pixels(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    GDALRasterIOExtraArg smooth;
    INIT_RASTERIO_EXTRA_ARG(smooth);
    smooth.eResampleAlg = GRIORA_Lanczos;
    std::array<int, 3> bands{1, 2, 3};
    if (GDALDatasetRasterIOEx(picture, GF_Read, 0, 0, columns, rows, pixels.data(), width, height, GDT_Byte, 3,
                              bands.data(), 3, 3 * static_cast<GSpacing>(width), 1, &smooth) != CE_None)
        refuse_picture(path, session);
    const GdalDataset memory(GDALCreate(GDALGetDriverByName("MEM"), "", width, height, 3, GDT_Byte, nullptr));
    if (GDALDatasetRasterIO(memory.get(), GF_Write, 0, 0, width, height, pixels.data(), width, height, GDT_Byte, 3,
                            bands.data(), 3, 3 * width, 1) != CE_None)
        refuse_picture(path, session);
    CPLStringList options;
    options.SetNameValue("QUALITY", std::to_string(quality).c_str());
    const NoSideFiles quiet;
    const MemoryFolder folder;
    const std::string place = folder.place_of("picture.jpg");
    GdalDataset written(GDALCreateCopy(GDALGetDriverByName("JPEG"), place.c_str(), memory.get(), FALSE, options.List(),
                                       nullptr, nullptr));
    if (!written) refuse_picture(path, session);
    written.reset();  // writes the last bytes
    vsi_l_offset size = 0;
    const GByte* const bytes = VSIGetMemFileBuffer(place.c_str(), &size, FALSE);
    if (bytes == nullptr || session.failed()) refuse_picture(path, session);
    return {"image/jpeg", {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)}, width, height};
}

}  // namespace

PagePicture page_picture(const std::string& path, int most_columns, std::size_t most_bytes) {
    const GdalSession session;
    const GdalDataset picture = open_picture(path, session);
    const int columns = GDALGetRasterXSize(picture.get()), rows = GDALGetRasterYSize(picture.get());
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size <= std::min(k_small_png, most_bytes) && columns <= most_columns)
        return {"image/png", bytes_of(path), columns, rows};
    PagePicture best;
    for (const Grade grade : k_grades) {
        const int width = std::max(1, static_cast<int>(grade.width * std::min(columns, most_columns)));
        best = as_jpeg(picture.get(), width, grade.quality, path, session);
        if (best.bytes.size() <= most_bytes) break;
    }
    return best;
}

namespace {

GdalDataset opened(const std::string& path, const std::string& crs_wkt, const Place& where) {
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

std::uint32_t check_picture(const std::string& path, const std::string& crs_wkt, const Place& where) {
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

namespace {

void set_place(GDALDatasetH dataset, const Bounds& box, const std::string& crs_wkt, const MapTurn& turn) {
    const Point corner = turn.map({box.west, box.north}),
                right = turn.map({box.width() / GDALGetRasterXSize(dataset), 0}),
                down = turn.map({0, -box.height() / GDALGetRasterYSize(dataset)});
    std::array<double, 6> geo{corner.x, right.x, down.x, corner.y, right.y, down.y};
    GDALSetGeoTransform(dataset, geo.data());
    if (crs_wkt.empty()) return;
    OGRSpatialReferenceH crs = OSRNewSpatialReference(crs_wkt.c_str());
    OSRSetAxisMappingStrategy(crs, OAMS_TRADITIONAL_GIS_ORDER);
    GDALSetSpatialRef(dataset, crs);
    OSRDestroySpatialReference(crs);
}

std::string neat_line(const Bounds& map, const MapTurn& turn) {
    std::string text;
    Ring ring = corners(map);
    ring.push_back(ring.front());
    for (const Point page : ring) {
        const Point corner = turn.map(page);
        std::array<char, 64> pair{};
        std::snprintf(pair.data(), pair.size(), "%.3f %.3f", corner.x, corner.y);
        text += (text.empty() ? "" : ",") + std::string(pair.data());
    }
    return "POLYGON ((" + text + "))";
}

}  // namespace

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
        set_place(page.get(), place->page, place->crs_wkt, place->turn);
        GDALSetMetadataItem(page.get(), "NEATLINE", neat_line(place->map, place->turn).c_str(), nullptr);
    }
    if (session.failed()) session.refuse_written("the picture", path);
    memory.write_to_disk(path, Sync::no);
}

}  // namespace frana::gis
