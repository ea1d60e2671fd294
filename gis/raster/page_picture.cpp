// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/page_picture.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/error.h"
#include "core/utf8.h"
#include "gis/access/gdal_session.h"
#include "gis/access/memory_dataset.h"
#include "gis/access/memory_folder.h"

namespace frana::gis {
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

}  // namespace frana::gis
