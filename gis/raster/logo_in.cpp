// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/logo_in.h"

#include <gdal.h>
#include <zlib.h>

#include <array>
#include <filesystem>

#include "core/error.h"
#include "gis/access/access_problem.h"
#include "gis/access/gdal_session.h"
#include "gis/access/local_files.h"
#include "gis/access/memory_dataset.h"
#include "gis/access/network.h"
#include "gis/access/time_limit.h"
#include "gis/raster/picture_colours.h"

namespace frana::gis {
namespace {

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

Logo read_logo(const std::string& path, const std::string& where) {
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

}  // namespace frana::gis
