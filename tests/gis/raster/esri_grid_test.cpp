// SPDX-License-Identifier: Apache-2.0
// The ESRI binary grid, a folder of .adf files, which GDAL reads but does not write: assembled here byte by byte.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;

// One tile of 3 blocks, each as wide as the grid and 4 rows high; the last is only partly used.
constexpr int k_grid_columns = 8, k_grid_rows = 10, k_block_rows = 4, k_blocks = 3;
constexpr double k_grid_west = 527000, k_grid_north = 5095000, k_grid_cell = 5;
constexpr float k_esri_nodata = -3.4028234663852886e38F;

class BigEndian {
  public:
    template <class T>
    BigEndian& put(T value) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        for (std::size_t i = sizeof(T); i > 0; --i) text_ += bytes[i - 1];  // this machine is little-endian
        return *this;
    }
    BigEndian& put_at(std::size_t place, std::int32_t value) {
        text_.replace(place, sizeof value, BigEndian().put(value).text_);
        return *this;
    }
    BigEndian& zeros_to(std::size_t size) {
        text_.resize(size, '\0');
        return *this;
    }
    [[nodiscard]] std::size_t size() const { return text_.size(); }
    void write(const std::string& path) const { std::ofstream(path, std::ios::binary) << text_; }

  private:
    std::string text_;
};

float ground(int row, int column) {
    return row == 9 && column == 7 ? k_esri_nodata
                                   : 1000.25F + 2 * static_cast<float>(column) + static_cast<float>(row);
}

void write_grid(const std::string& folder) {
    std::filesystem::create_directory(folder);
    BigEndian header;
    header.put<std::uint64_t>(0x47524944312E3200).put<std::int64_t>(0);  // "GRID1.2"
    header.put<std::int32_t>(2).put<std::int32_t>(1).zeros_to(256);      // real numbers, not compressed
    header.put(k_grid_cell).put(k_grid_cell).put(0.0).put(0.0);          // cells, reference
    header.put<std::int32_t>(1).put<std::int32_t>(k_blocks).put<std::int32_t>(k_grid_columns);
    header.put<std::int32_t>(1).put<std::int32_t>(k_block_rows).zeros_to(308);
    header.write(folder + "/hdr.adf");
    BigEndian bounds;
    bounds.put(k_grid_west)
        .put(k_grid_north - k_grid_rows * k_grid_cell)
        .put(k_grid_west + k_grid_columns * k_grid_cell)
        .put(k_grid_north);
    bounds.write(folder + "/dblbnd.adf");
    BigEndian statistics;
    statistics.put(1000.25).put(1023.25).put(1011.0).put(5.0).write(folder + "/sta.adf");

    constexpr std::uint64_t k_magic = 0x0000270AFFFFFC14;
    BigEndian data, index;
    data.put(k_magic).zeros_to(100);
    index.put(k_magic).zeros_to(100);
    constexpr int k_shorts = 2 * k_grid_columns * k_block_rows;
    for (int block = 0; block < k_blocks; ++block) {
        index.put(static_cast<std::int32_t>(data.size() / 2)).put<std::int32_t>(k_shorts);
        data.put<std::int16_t>(k_shorts);
        for (int row = block * k_block_rows; row < (block + 1) * k_block_rows; ++row)
            for (int column = 0; column < k_grid_columns; ++column)
                data.put(row < k_grid_rows ? ground(row, column) : k_esri_nodata);
    }
    // Both contain their length in shorts at byte 24.
    data.put_at(24, static_cast<std::int32_t>(data.size() / 2)).write(folder + "/w001001.adf");
    index.put_at(24, static_cast<std::int32_t>(index.size() / 2)).write(folder + "/w001001x.adf");
    std::ofstream(folder + "/prj.adf") << "Projection    UTM\nZone          32\nDatum         WGS84\nZunits        NO\n"
                                          "Units         METERS\nSpheroid      WGS84\nXshift        0.0\n"
                                          "Yshift        0.0\nParameters\n";
}

TEST(EsriGrid, AFolderOfAdfFilesIsARaster) {
    const Folder folder;
    const std::string path = folder.file("dtm");
    write_grid(path);
    const RasterInfo info = inspect_raster(path, "terrain.dtm");
    EXPECT_EQ(info.driver, "AIG");
    EXPECT_EQ(info.columns, k_grid_columns);
    EXPECT_EQ(info.rows, k_grid_rows);
    EXPECT_FALSE(info.crs_wkt.empty());  // UTM zone 32 is tested below, where nothing is resampled
    const GridSpec grid{k_grid_west,    k_grid_north, k_grid_cell,
                        k_grid_columns, k_grid_rows,  crs_from_user("EPSG:32632", "")};
    const RasterRead read = read_raster_on(path, grid, "", Resampling::automatic);
    EXPECT_EQ(read.resampling_used, "exact copy");
    EXPECT_EQ(read.nodata_cells, 1);
    for (int row = 0; row < k_grid_rows; ++row) {
        for (int column = 0; column < k_grid_columns; ++column) {
            if (row == 9 && column == 7)
                EXPECT_TRUE(std::isnan(read.raster.at(row, column)));
            else
                EXPECT_EQ(read.raster.at(row, column), ground(row, column)) << row << ", " << column;
        }
    }
}

}  // namespace
}  // namespace frana::gis
