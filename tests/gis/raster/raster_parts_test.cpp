// SPDX-License-Identifier: Apache-2.0
// Parts of a raster that are read on demand are those of the whole; of a large raster only what is stored is written
// and read.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "gis/access/gdal_session.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/raster_in.h"
#include "gis/raster/raster_out.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::Folder;
using test::TestRaster;

// Hills of 10 m, with a hole.
TestRaster hills(const std::string& crs) {
    TestRaster raster;
    raster.columns = 400;
    raster.rows = 300;
    raster.west = 527'000;
    raster.north = 5'095'000;
    raster.cell_x = raster.cell_y = 2;
    raster.crs = crs;
    raster.nodata = -9999;
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column)
            raster.values.push_back(std::hypot(row - 100, column - 90) < 9
                                        ? -9999
                                        : 500 + 10 * std::sin(0.05 * column) * std::cos(0.03 * row));
    return raster;
}

// By windows that share no edge with the strips of a whole read.
void expect_parts_of_the_whole(const std::string& file, const GridSpec& grid, double tolerance) {
    const Raster whole = read_raster_on(file, grid, "", Resampling::automatic).raster;
    const RasterOnDemand parts(file, grid, "", Resampling::automatic, "auto", std::nullopt, "terrain.dtm");
    std::int64_t numbers = 0;
    for (const CellWindow window : {CellWindow{0, 0, 64, 64}, CellWindow{64, 64, 50, 31}, CellWindow{3, 17, 90, 80}}) {
        std::vector<double> values(static_cast<std::size_t>(window.rows * window.columns));
        parts.read(window, values.data());
        auto next = values.begin();
        for (std::int64_t row = 0; row < window.rows; ++row) {
            for (std::int64_t column = 0; column < window.columns; ++column, ++next) {
                const double here = whole.at(window.row + row, window.column + column);
                ASSERT_EQ(std::isnan(here), std::isnan(*next)) << row << " " << column;
                if (std::isnan(here)) continue;
                ++numbers;
                ASSERT_LE(std::abs(here - *next), tolerance) << row << " " << column;
            }
        }
    }
    EXPECT_GT(numbers, 10'000);
}

TEST(RasterOnDemand, ReadsPartsAsTheWhole) {
    const Folder folder;
    const std::string file = folder.file("hills.tif");
    test::make_raster(file, hills("EPSG:32632"));
    GridSpec grid{527'000, 5'095'000, 2, 400, 300, crs_from_user("EPSG:32632", "")};
    expect_parts_of_the_whole(file, grid, 0);  // copied
    grid = {527'001, 5'094'999, 2, 395, 295, grid.crs_wkt};
    expect_parts_of_the_whole(file, grid, 0);  // between the cells
    grid = {527'000, 5'095'000, 5, 160, 120, grid.crs_wkt};
    expect_parts_of_the_whole(file, grid, 0);  // their mean
}

// Places are interpolated within 0.01 cells there, computed one by one here; the hills rise by 0.5 m a cell at most.
TEST(RasterOnDemand, IsWithinAHundredthOfACellInAnotherCrs) {
    const Folder folder;
    const std::string file = folder.file("hills.tif");
    TestRaster raster = hills("EPSG:32632");
    for (double& value : raster.values)
        if (value == -9999) value = 500;
    test::make_raster(file, raster);
    const Bounds box = CrsTransform(crs_from_user("EPSG:32632", ""), crs_from_user("EPSG:32633", ""))
                           .around({527'050, 5'094'450, 527'750, 5'094'950});
    const GridSpec grid{std::round(box.west) + 50,      std::round(box.north) - 50, 2, 250, 180,
                        crs_from_user("EPSG:32633", "")};
    expect_parts_of_the_whole(file, grid, 0.01);
}

TEST(LargeRaster, IsWrittenAndReadWhereSomethingIsStored) {
    const Folder folder;
    const std::string file = folder.file("large.tif");
    Raster raster(GridSpec{500'000, 5'200'000, 2, 20'000, 18'000, crs_from_user("EPSG:32632", "")}, k_no_data);
    ASSERT_TRUE(raster.values.is_tiled());
    raster.at(0, 0) = 1.5;
    raster.at(9'000, 12'345) = -2;
    raster.at(17'999, 19'999) = 4;
    raster.at(17'998, 19'999) = k_no_data;
    write_geotiff(file, raster, {"depth", "Depth", "m", {}});
    EXPECT_LT(std::filesystem::file_size(file), 200'000U);
    const Raster back = read_result_raster(file);
    EXPECT_TRUE(back.grid.same_cells(raster.grid));
    EXPECT_LT(back.values.stored_cells(), 20'000);
    std::vector<double> values;
    back.values.for_each_stored([&](std::size_t, double value) {
        if (!std::isnan(value)) values.push_back(value);
    });
    EXPECT_EQ(values, (std::vector<double>{1.5, -2, 4}));
    EXPECT_EQ(back.at(9'000, 12'345), -2);
    const GdalSession session;
    const GDALDatasetUniquePtr opened(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
    ASSERT_TRUE(opened);
    EXPECT_STREQ(opened->GetRasterBand(1)->GetMetadataItem("STATISTICS_MAXIMUM"), "4");
    EXPECT_EQ(opened->GetRasterBand(1)->GetNoDataValue(), -9999);
}

}  // namespace
}  // namespace frana::gis
