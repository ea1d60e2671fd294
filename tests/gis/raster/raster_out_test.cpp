// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/raster_out.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "core/reached_raster.h"
#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "support/cog_check.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::error_of;
using test::Folder;

Raster bowl(int columns, int rows) {
    Raster raster(GridSpec{527000, 5095000, 2, columns, rows, crs_from_user("EPSG:32632", "")}, k_no_data);
    for (int row = rows / 4; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) raster.at(row, column) = 0.1 * column + std::sin(row * 0.1);
    }
    return raster;
}

const BandText k_text{"max_depth", "Maximum flow depth, vertical", "m", {{"PROGRAM", "frana"}, {"VERSION", "0"}}};

/// Limits the size of any file during its lifetime, as a full disk does.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST(WriteGeotiff, IsReadBackOnItsOwnGrid) {
    const Folder folder;
    const Raster raster = bowl(600, 500);
    write_geotiff(folder.file("max_depth.tif"), raster, k_text);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"max_depth.tif"}) << "nothing beside it";
    const Raster back = read_result_raster(folder.file("max_depth.tif"));
    EXPECT_TRUE(back.grid.same_cells(raster.grid));
    EXPECT_EQ(crs_name(back.grid.crs_wkt), "EPSG:32632 (WGS 84 / UTM zone 32N)");
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        if (std::isnan(raster.values[i])) {
            ASSERT_TRUE(std::isnan(back.values[i]));
        } else {
            ASSERT_EQ(back.values[i], static_cast<float>(raster.values[i]));
        }
    }
}

// Tiles are how it is kept, not what is written.
TEST(WriteGeotiff, OfWhatAFlowReachesIsThatOfAPlainRaster) {
    const Folder folder;
    const Raster plain = bowl(600, 500);
    Raster tiled = reached_raster(plain.grid, k_no_data);
    ASSERT_TRUE(tiled.values.is_tiled());
    for (std::size_t i = 0; i < plain.values.size(); ++i)
        if (!std::isnan(plain.values[i])) tiled.values[i] = plain.values[i];
    ASSERT_LT(tiled.values.stored_cells(), 600 * 500);
    write_geotiff(folder.file("plain.tif"), plain, k_text);
    write_geotiff(folder.file("tiled.tif"), tiled, k_text);
    EXPECT_EQ(test::text_in(folder.file("tiled.tif")), test::text_in(folder.file("plain.tif")));
    EXPECT_FALSE(reached_raster({0, 0, 1, 512, 512, ""}, 0).values.is_tiled());
}

TEST(WriteGeotiff, IsCloudOptimisedWithTextsAndStatisticsInside) {
    const Folder folder;
    const Raster raster = bowl(600, 500);
    write_geotiff(folder.file("a.tif"), raster, k_text);
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(folder.file("a.tif").c_str(), GDAL_OF_RASTER));
    ASSERT_TRUE(file);
    EXPECT_STREQ(file->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG");
    EXPECT_STREQ(file->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");
    EXPECT_STREQ(file->GetMetadataItem("PROGRAM"), "frana");
    GDALRasterBand& band = *file->GetRasterBand(1);
    EXPECT_EQ(band.GetRasterDataType(), GDT_Float32);
    EXPECT_EQ(band.GetNoDataValue(), -9999);
    EXPECT_STREQ(band.GetDescription(), "max_depth: Maximum flow depth, vertical [m]");
    EXPECT_STREQ(band.GetUnitType(), "m");
    EXPECT_EQ(band.GetOverviewCount(), 2);  // 300 x 250, 150 x 125
    int block_x = 0, block_y = 0;
    band.GetBlockSize(&block_x, &block_y);
    EXPECT_EQ(block_x, 256);
    const char* most = band.GetMetadataItem("STATISTICS_MAXIMUM");
    ASSERT_TRUE(most);
    float expected = -1;
    for (const double value : raster.values) {
        if (!std::isnan(value)) expected = std::max(expected, static_cast<float>(value));
    }
    EXPECT_EQ(static_cast<float>(std::atof(most)), expected);
    // GDAL's own statistics of the file must agree.
    double least = 0, greatest = 0, mean = 0, deviation = 0;
    ASSERT_EQ(band.ComputeStatistics(FALSE, &least, &greatest, &mean, &deviation, nullptr, nullptr), CE_None);
    EXPECT_EQ(greatest, expected);
    const GDALDatasetUniquePtr fresh(GDALDataset::Open(folder.file("a.tif").c_str(), GDAL_OF_RASTER));
    EXPECT_NEAR(std::atof(fresh->GetRasterBand(1)->GetMetadataItem("STATISTICS_MEAN")), mean, 1e-9 * std::abs(mean));
    EXPECT_NEAR(std::atof(fresh->GetRasterBand(1)->GetMetadataItem("STATISTICS_STDDEV")), deviation, 1e-9 * deviation);
}

TEST(WriteGeotiff, IsValidByTheRulesOfGdalsValidator) {
    const Folder folder;
    for (const int columns : {3, 255, 256, 257, 1100}) {
        write_geotiff(folder.file("a.tif"), bowl(columns, 600), k_text);
        EXPECT_EQ(test::cog_problems(folder.file("a.tif")), std::vector<std::string>{}) << columns;
        write_class_geotiff(folder.file("c.tif"), Raster(bowl(columns, 600).grid, 1), {{1, "one", {1, 2, 3}}}, k_text);
        EXPECT_EQ(test::cog_problems(folder.file("c.tif")), std::vector<std::string>{}) << columns;
    }
}

TEST(WriteGeotiff, TheCheckDetectsFilesThatAreNotCloudOptimised) {
    const Folder folder;
    write_geotiff(folder.file("a.tif"), bowl(1100, 600), k_text);
    const GdalSession session;
    {
        const GDALDatasetUniquePtr file(GDALDataset::Open(folder.file("a.tif").c_str(), GDAL_OF_RASTER));
        GDALDriver* tiff = GetGDALDriverManager()->GetDriverByName("GTiff");
        const GDALDatasetUniquePtr striped(
            tiff->CreateCopy(folder.file("b.tif").c_str(), file.get(), TRUE, nullptr, nullptr, nullptr));
    }
    EXPECT_FALSE(test::cog_problems(folder.file("b.tif")).empty()) << "stripes";
    {
        // A value changed in place: GDAL rewrites blocks and marks that in the file.
        const GDALDatasetUniquePtr file(
            GDALDataset::Open(folder.file("a.tif").c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
        std::vector<float> values(1100 * 300);
        std::uint32_t noise = 1;  // which does not compress, so that blocks exceed their place
        for (float& value : values) value = static_cast<float>(noise = noise * 1664525 + 1013904223);
        ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 1100, 300, values.data(), 1100, 300, GDT_Float32, 0,
                                                   0, nullptr),
                  CE_None);
    }
    EXPECT_FALSE(test::cog_problems(folder.file("a.tif")).empty()) << "edited";
}

TEST(WriteGeotiff, OverviewsDoNotMixInNoData) {
    const Folder folder;
    const Raster raster = bowl(600, 500);
    write_geotiff(folder.file("a.tif"), raster, k_text);
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(folder.file("a.tif").c_str(), GDAL_OF_RASTER));
    GDALRasterBand& overview = *file->GetRasterBand(1)->GetOverview(1);
    std::vector<float> values(static_cast<std::size_t>(overview.GetXSize()) * overview.GetYSize());
    ASSERT_EQ(overview.RasterIO(GF_Read, 0, 0, overview.GetXSize(), overview.GetYSize(), values.data(),
                                overview.GetXSize(), overview.GetYSize(), GDT_Float32, 0, 0),
              CE_None);
    for (const float value : values) ASSERT_TRUE(value == -9999.0F || value >= -1.0F) << value;
}

TEST(WriteGeotiff, SmallAndEmptyRastersToo) {
    const Folder folder;
    write_geotiff(folder.file("small.tif"), Raster(GridSpec{0, 10, 5, 2, 2, ""}, 1.5), k_text);
    EXPECT_EQ(read_result_raster(folder.file("small.tif")).values, std::vector<double>(4, 1.5));
    EXPECT_TRUE(read_result_raster(folder.file("small.tif")).grid.crs_wkt.empty());
    write_geotiff(folder.file("none.tif"), Raster(GridSpec{0, 10, 5, 2, 2, ""}, k_no_data), k_text);
    for (const double value : read_result_raster(folder.file("none.tif")).values) EXPECT_TRUE(std::isnan(value));
}

TEST(WriteGeotiff, AFailureLeavesTheOldFileAndNothingElse) {
    const Folder folder;
    const std::string path = folder.file("a.tif");
    write_geotiff(path, bowl(20, 20), k_text);
    const std::string before = test::text_in(path);
    for (const rlim_t room : {0, 1000, 20000}) {
        const FullDisk full(room);
        const Error error = error_of([&] { write_geotiff(path, bowl(600, 500), k_text); });
        EXPECT_EQ(error.kind(), ErrorKind::environment) << room;
        EXPECT_EQ(error.problems().front().where, path);
    }
    EXPECT_TRUE(test::text_in(path) == before);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.tif"});
    const Error error = error_of([&] { write_geotiff(folder.file("no/such/folder/a.tif"), bowl(20, 20), k_text); });
    EXPECT_EQ(error.kind(), ErrorKind::environment);
}

TEST(WriteClassGeotiff, KeepsNamesAndColours) {
    const Folder folder;
    Raster classes(GridSpec{527000, 5095000, 5, 3, 2, crs_from_user("EPSG:32632", "")}, k_no_data);
    classes.values = {1, 2, 3, k_no_data, 1, 0};
    const std::vector<ClassEntry> entries{
        {1, "hit", {0, 100, 0}}, {2, "false alarm", {200, 0, 0}}, {3, "miss", {0, 0, 9}}};
    write_class_geotiff(folder.file("c.tif"), classes, entries, {"comparison", "Against the scar", "", {}});
    EXPECT_EQ(folder.names(), std::vector<std::string>{"c.tif"});
    const Raster back = read_result_raster(folder.file("c.tif"));
    EXPECT_EQ(back.values[1], 2);
    EXPECT_TRUE(std::isnan(back.values[3]) && std::isnan(back.values[5]));
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(folder.file("c.tif").c_str(), GDAL_OF_RASTER));
    GDALRasterBand& band = *file->GetRasterBand(1);
    ASSERT_TRUE(band.GetColorTable());
    EXPECT_EQ(band.GetColorTable()->GetColorEntry(2)->c1, 200);
    EXPECT_STREQ(band.GetMetadataItem("CLASS_3"), "miss");
    classes.values[0] = 7;
    EXPECT_EQ(error_of([&] { write_class_geotiff(folder.file("d.tif"), classes, entries, {}); }).kind(),
              ErrorKind::input);
}

TEST(ReadResultRaster, RefusesRastersThatCannotBeDrawnExactly) {
    const Folder folder;
    test::make_raster(folder.file("degrees.tif"),
                      {2, 2, 9, 46, 0.1, 0.1, "EPSG:4326", {1, 2, 3, 4}, {}, "", 1, 0, 0, false});
    test::make_raster(folder.file("oblong.tif"),
                      {2, 2, 9, 46, 1, 2, "EPSG:32632", {1, 2, 3, 4}, {}, "", 1, 0, 0, false});
    test::make_raster(folder.file("tilted.tif"),
                      {2, 2, 9, 46, 1, 1, "EPSG:32632", {1, 2, 3, 4}, {}, "", 1, 0, 0.3, false});
    for (const char* name : {"degrees.tif", "oblong.tif", "tilted.tif", "missing.tif"}) {
        EXPECT_EQ(error_of([&] { (void)read_result_raster(folder.file(name)); }).kind(), ErrorKind::input) << name;
    }
}

}  // namespace
}  // namespace frana::gis
