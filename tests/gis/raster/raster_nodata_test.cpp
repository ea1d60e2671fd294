// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"
#include "plane_raster.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;
using test::k_nan;
using test::make_raster;
using test::plane_raster;
using test::TestRaster;
using test::utm_grid;

TEST(ReadRaster, NoDataRemainsAndDoesNotSpread) {
    const Folder folder;
    TestRaster raster = plane_raster(20, 20, 5);
    for (double& value : raster.values) value = 500;
    raster.nodata = -9999;
    raster.values[10 * 20 + 10] = -9999;
    raster.values[3 * 20 + 4] = k_nan;  // undeclared, but not finite either
    raster.values[15 * 20 + 4] = std::numeric_limits<double>::infinity();
    make_raster(folder.file("dtm.tif"), raster);
    for (const Resampling resampling : {Resampling::bilinear, Resampling::cubic, Resampling::nearest}) {
        const GridSpec grid = utm_grid(527000, 5095000, 1, 100, 100);
        const RasterRead read = read_raster_on(folder.file("dtm.tif"), grid, "", resampling);
        // Each hole is 5 x 5 fine cells.
        EXPECT_EQ(read.nodata_cells, 75) << read.resampling_used;
        EXPECT_TRUE(std::isnan(read.raster.at(52, 52)));
        for (const double value : read.raster.values) {
            ASSERT_TRUE(std::isnan(value) || std::abs(value - 500) < 1e-9) << value;
        }
    }
    const RasterRead coarse =
        read_raster_on(folder.file("dtm.tif"), utm_grid(527000, 5095000, 20, 5, 5), "", Resampling::average);
    EXPECT_EQ(coarse.nodata_cells, 0);
    for (const double value : coarse.raster.values) ASSERT_NEAR(value, 500, 1e-9);
    const RasterRead same =
        read_raster_on(folder.file("dtm.tif"), utm_grid(527000, 5095000, 5, 20, 20), "", Resampling::automatic);
    EXPECT_EQ(same.nodata_cells, 3);
    EXPECT_TRUE(same.warnings.empty());
}

TEST(ReadRaster, WarnsOfABandOf9999ButNotOfSlopesThatPassIt) {
    const Folder folder;
    const GridSpec grid = utm_grid(527000, 5095000, 5, 20, 20);
    TestRaster raster = plane_raster(20, 20, 5);
    for (std::size_t i = 0; i < raster.values.size(); ++i) raster.values[i] = i % 20 < 4 ? 9999 : 500;
    make_raster(folder.file("band.tif"), raster);
    const RasterRead band = read_raster_on(folder.file("band.tif"), grid, "", Resampling::automatic);
    ASSERT_EQ(band.warnings.size(), 1U);
    EXPECT_NE(band.warnings[0].text().find("80 cells of 9999,"), std::string::npos) << band.warnings[0].text();
    // In centimetres, at 100 m: steps of 45 degrees pass the value.
    for (std::size_t i = 0; i < raster.values.size(); ++i) raster.values[i] = 4999 + 500 * static_cast<double>(i % 20);
    raster.scale = 0.01;
    make_raster(folder.file("slope.tif"), raster);
    EXPECT_TRUE(read_raster_on(folder.file("slope.tif"), grid, "", Resampling::automatic).warnings.empty());
}

TEST(ReadRaster, ScaleAndOffsetApplyButNotToNoData) {
    const Folder folder;
    TestRaster raster = plane_raster(2, 2, 5);
    raster.values = {0, 1, 2, 255};
    raster.bytes = true;
    raster.nodata = 255;
    raster.scale = 0.5;
    raster.offset = 100;
    make_raster(folder.file("dtm.tif"), raster);
    const RasterRead read =
        read_raster_on(folder.file("dtm.tif"), utm_grid(527000, 5095000, 5, 2, 2), "", Resampling::automatic);
    EXPECT_EQ(read.raster.values[0], 100);
    EXPECT_EQ(read.raster.values[2], 101);
    EXPECT_TRUE(std::isnan(read.raster.values[3]));
}

TEST(ReadRaster, MasksHideCells) {
    const Folder folder;
    const GdalSession session;
    make_raster(folder.file("dtm.tif"), plane_raster(4, 4, 5));
    std::vector<std::uint8_t> seen(16, 255);
    seen[5] = 0;
    {
        const GDALDatasetUniquePtr file(GDALDataset::Open(folder.file("dtm.tif").c_str(), GDAL_OF_UPDATE));
        ASSERT_EQ(file->CreateMaskBand(GMF_PER_DATASET), CE_None);
        ASSERT_EQ(
            file->GetRasterBand(1)->GetMaskBand()->RasterIO(GF_Write, 0, 0, 4, 4, seen.data(), 4, 4, GDT_Byte, 0, 0),
            CE_None);
    }
    const RasterRead masked =
        read_raster_on(folder.file("dtm.tif"), utm_grid(527000, 5095000, 5, 4, 4), "", Resampling::automatic);
    EXPECT_EQ(masked.nodata_cells, 1);
    EXPECT_TRUE(std::isnan(masked.raster.at(1, 1)));
}

TEST(ReadRaster, AFrameOfZerosIsDetectedAndCanBeDeclared) {
    const Folder folder;
    TestRaster raster = plane_raster(20, 20, 5);
    for (std::size_t i = 0; i < 20; ++i) raster.values[i] = 0;
    make_raster(folder.file("framed.tif"), raster);
    const GridSpec grid = utm_grid(527000, 5095000, 5, 20, 20);
    const RasterRead framed = read_raster_on(folder.file("framed.tif"), grid, "", Resampling::automatic);
    EXPECT_EQ(framed.zero_rim_cells, 20);
    EXPECT_EQ(framed.nodata_cells, 0) << "nothing is taken for no data unasked";
    const RasterRead declared = read_raster_on(folder.file("framed.tif"), grid, "", Resampling::automatic, "auto", 0);
    EXPECT_EQ(declared.nodata_cells, 20);
    EXPECT_EQ(declared.zero_rim_cells, 0);
    // The sea: its shore rises gradually.
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column)
            raster.values[static_cast<std::size_t>(row * 20 + column)] = std::max(0, 2 * (column - 5));
    make_raster(folder.file("shore.tif"), raster);
    EXPECT_EQ(read_raster_on(folder.file("shore.tif"), grid, "", Resampling::automatic).zero_rim_cells, 0);
    // Resampled, the frame would no longer be 0: it is detected in the file.
    EXPECT_EQ(
        read_raster_on(folder.file("framed.tif"), utm_grid(527000, 5095000, 10, 10, 10), "", Resampling::automatic)
            .zero_rim_cells,
        20);
}

TEST(ReadRaster, UndeclaredNoDataIsDetectedBeforeItIsAveraged) {
    const Folder folder;
    TestRaster raster = plane_raster(20, 20, 5);
    raster.values[45] = -32767;
    make_raster(folder.file("dtm.tif"), raster);
    const RasterRead read =
        read_raster_on(folder.file("dtm.tif"), utm_grid(527000, 5095000, 10, 10, 10), "", Resampling::automatic);
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_NE(read.warnings[0].text().find("cells of -32767"), std::string::npos) << read.warnings[0].text();
}

TEST(FillNodata, FillsHolesNearDataAndNothingElse) {
    Raster raster(utm_grid(527000, 5095000, 5, 30, 30), 100.123456789);
    raster.at(10, 10) = raster.at(10, 11) = k_no_data;
    EXPECT_EQ(fill_nodata(raster, 5), 2);
    EXPECT_NEAR(raster.at(10, 10), 100.123456789, 1e-5);  // GDAL fills in single precision
    EXPECT_EQ(raster.at(0, 0), 100.123456789);
    EXPECT_EQ(fill_nodata(raster, 5), 0);
    for (int row = 0; row < 30; ++row) {
        for (int column = 5; column < 30; ++column) raster.at(row, column) = k_no_data;
    }
    EXPECT_LE(fill_nodata(raster, 3), 30 * 4);
    EXPECT_TRUE(std::isnan(raster.at(15, 29)));
}

}  // namespace
}  // namespace frana::gis
