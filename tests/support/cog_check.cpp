// SPDX-License-Identifier: Apache-2.0
#include "support/cog_check.h"

#include <gdal_priv.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "gis/access/gdal_session.h"
#include "support/files.h"

namespace frana::gis::test {
namespace {

std::uint64_t number(GDALRasterBand& band, const std::string& item) {
    const char* text = band.GetMetadataItem(item.c_str(), "TIFF");
    return text ? std::strtoull(text, nullptr, 10) : 0;
}

std::string at(const char* what, int x, int y) {
    return std::string(what) + std::to_string(x) + "_" + std::to_string(y);
}

struct Blocks {
    int across = 0, down = 0;
    explicit Blocks(GDALRasterBand& band) {
        int width = 0, height = 0;
        band.GetBlockSize(&width, &height);
        across = (band.GetXSize() + width - 1) / width;
        down = (band.GetYSize() + height - 1) / height;
    }
};

std::uint64_t first_data(GDALRasterBand& band) {
    const Blocks blocks(band);
    for (int y = 0; y < blocks.down; ++y)
        for (int x = 0; x < blocks.across; ++x)
            if (const std::uint64_t offset = number(band, at("BLOCK_OFFSET_", x, y))) return offset;
    return 0;
}

void check_blocks(GDALRasterBand& band, const std::string& bytes, const std::string& name,
                  std::vector<std::string>& problems) {
    const Blocks blocks(band);
    std::uint64_t last = 0;
    for (int y = 0; y < blocks.down; ++y) {
        for (int x = 0; x < blocks.across; ++x) {
            const std::uint64_t offset = number(band, at("BLOCK_OFFSET_", x, y));
            const std::uint64_t size = number(band, at("BLOCK_SIZE_", x, y));
            if (offset == 0) continue;
            if (offset < last) problems.push_back(name + ": blocks are not in row order");
            last = offset;
            std::uint32_t leader = 0;
            std::memcpy(&leader, bytes.data() + offset - 4, 4);
            if (leader != size) problems.push_back(name + ": a block's leader is not its size");
            if (size >= 4 && bytes.compare(offset + size - 4, 4, bytes, offset + size, 4) != 0)
                problems.push_back(name + ": a block's trailer does not repeat its last bytes");
        }
    }
}

}  // namespace

std::vector<std::string> cog_problems(const std::string& path) {
    const GdalSession session;
    std::vector<std::string> problems;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
    if (!file) return {"cannot be opened"};
    const std::string bytes = text_in(path);
    const std::string ghost = bytes.substr(8, 1024);
    for (const char* promise : {"GDAL_STRUCTURAL_METADATA_SIZE=", "LAYOUT=IFDS_BEFORE_DATA", "BLOCK_ORDER=ROW_MAJOR",
                                "BLOCK_LEADER=SIZE_AS_UINT4", "BLOCK_TRAILER=LAST_4_BYTES_REPEATED"})
        if (ghost.find(promise) == std::string::npos) problems.push_back(std::string("no ") + promise);
    if (ghost.find("KNOWN_INCOMPATIBLE_EDITION=YES") != std::string::npos)
        problems.emplace_back("was edited after it was written");

    std::vector<GDALRasterBand*> images{file->GetRasterBand(1)};
    for (int i = 0; i < images[0]->GetOverviewCount(); ++i) images.push_back(images[0]->GetOverview(i));
    const bool large = images[0]->GetXSize() > 512 || images[0]->GetYSize() > 512;
    if (large && images.size() == 1) problems.emplace_back("large, but without overviews");
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::string name = "image " + std::to_string(i);
        int width = 0, height = 0;
        images[i]->GetBlockSize(&width, &height);
        if (width != height) problems.push_back(name + ": not tiled");
        check_blocks(*images[i], bytes, name, problems);
        if (i == 0) continue;
        if (images[i]->GetXSize() > images[i - 1]->GetXSize() || images[i]->GetYSize() > images[i - 1]->GetYSize())
            problems.push_back(name + ": larger than the one before");
        if (number(*images[i], "IFD_OFFSET") < number(*images[i - 1], "IFD_OFFSET"))
            problems.push_back(name + ": its directory comes before that of a larger image");
        const std::uint64_t here = first_data(*images[i]), larger = first_data(*images[i - 1]);
        if (here != 0 && larger != 0 && here > larger)
            problems.push_back(name + ": its data come after those of a larger image");
    }
    const std::uint64_t first = first_data(*images.back());
    if (first != 0 && first < number(*images.back(), "IFD_OFFSET"))
        problems.emplace_back("data come before the last directory");
    return problems;
}

}  // namespace frana::gis::test
