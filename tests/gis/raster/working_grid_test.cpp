// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/working_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gis/crs/crs.h"
#include "support/files.h"

namespace frana::gis {
namespace {

using test::error_of;

RasterInfo dtm_5m() {
    RasterInfo info;
    info.path = "dtm.tif";
    info.crs_wkt = crs_from_user("EPSG:32632", "");
    info.bounds = {527002.5, 5093997.5, 528502.5, 5095347.5};
    info.columns = 300;
    info.rows = 270;
    info.cell_x = info.cell_y = 5;
    return info;
}

TEST(WorkingGrid, IsTheDtmsOwnByDefault) {
    const RasterInfo dtm = dtm_5m();
    const GridSpec grid = working_grid(dtm, dtm.crs_wkt, std::nullopt, std::nullopt);
    EXPECT_EQ(grid.west, 527002.5);
    EXPECT_EQ(grid.north, 5095347.5);
    EXPECT_EQ(grid.cell_size, 5);
    EXPECT_EQ(grid.columns, 300);
    EXPECT_EQ(grid.rows, 270);
    EXPECT_TRUE(is_projected_in_metres(grid.crs_wkt));
}

TEST(WorkingGrid, BoundsKeepTheDtmsLattice) {
    const RasterInfo dtm = dtm_5m();
    const GridSpec grid = working_grid(dtm, dtm.crs_wkt, Bounds{527100, 5094100, 527200, 5094200}, std::nullopt);
    EXPECT_EQ(grid.west, 527097.5);
    EXPECT_EQ(grid.east(), 527202.5);
    EXPECT_EQ(grid.south(), 5094097.5);
    EXPECT_EQ(grid.north, 5094202.5);
}

TEST(WorkingGrid, OtherCellsAreOnMultiplesAndInsideTheDtm) {
    const RasterInfo dtm = dtm_5m();
    const GridSpec grid = working_grid(dtm, dtm.crs_wkt, std::nullopt, 2.0);
    EXPECT_EQ(std::fmod(grid.west, 2), 0);
    EXPECT_EQ(std::fmod(grid.north, 2), 0);
    EXPECT_GE(grid.west, dtm.bounds.west);
    EXPECT_LE(grid.east(), dtm.bounds.east);
    EXPECT_GE(grid.south(), dtm.bounds.south);
    EXPECT_LE(grid.north, dtm.bounds.north);
    EXPECT_EQ(grid.columns, 749);  // 1500 m minus the partial cells at both ends
}

TEST(WorkingGrid, DegreesBecomeARoundNumberOfMetres) {
    RasterInfo dtm = dtm_5m();
    dtm.crs_wkt = crs_from_user("EPSG:4326", "");
    dtm.cell_x = dtm.cell_y = 1.0 / 3600;  // 1 arc second: 21.5 m by 30.9 m at 46 degrees north
    dtm.bounds = {9.3, 45.95, 9.4, 46.05};
    const GridSpec grid = working_grid(dtm, utm_crs_for(9.35, 46), std::nullopt, std::nullopt);
    EXPECT_EQ(grid.cell_size, 22);  // 21.53 to two digits
    EXPECT_NEAR(grid.west, 523240, 300);
    EXPECT_NEAR(grid.bounds().height(), 11120, 100);  // a tenth of a degree of latitude
}

TEST(WorkingGrid, OblongCellsGiveTheSmallerSide) {
    RasterInfo dtm = dtm_5m();
    dtm.cell_y = 4.5;
    EXPECT_EQ(working_grid(dtm, dtm.crs_wkt, std::nullopt, std::nullopt).cell_size, 4.5);
}

TEST(WorkingGrid, LocalNeedsNoCrs) {
    RasterInfo dtm = dtm_5m();
    dtm.crs_wkt.clear();
    const GridSpec grid = working_grid(dtm, "", std::nullopt, std::nullopt);
    EXPECT_TRUE(grid.crs_wkt.empty());
    EXPECT_EQ(grid.columns, 300);
}

TEST(WorkingGrid, RefusesAbsurdSizes) {
    const RasterInfo dtm = dtm_5m();
    EXPECT_EQ(error_of([&] { (void)working_grid(dtm, dtm.crs_wkt, std::nullopt, 0.01); }).kind(), ErrorKind::input);
    EXPECT_EQ(error_of([&] { (void)working_grid(dtm, dtm.crs_wkt, std::nullopt, 5000.0); }).kind(), ErrorKind::input);
}

}  // namespace
}  // namespace frana::gis
