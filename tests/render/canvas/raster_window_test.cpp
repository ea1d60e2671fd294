// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frana::render {
namespace {

Raster ramp() {
    Raster raster(GridSpec{100, 500, 2, 40, 30, ""});
    for (std::int64_t row = 0; row < 30; ++row) {
        for (std::int64_t column = 0; column < 40; ++column) {
            const Point p = raster.grid.cell_centre(row, column);
            raster.at(row, column) = 3 * p.x - p.y;
        }
    }
    return raster;
}

TEST(RasterWindow, WholeCellsKeepTheirPlace) {
    const Raster part = raster_window(ramp(), {120, 460, 140, 470}, 1000);
    EXPECT_EQ(part.grid.cell_size, 2);
    EXPECT_LE(part.grid.west, 120 - 2);
    EXPECT_GE(part.grid.east(), 140 + 2);
    for (std::int64_t row = 0; row < part.grid.rows; ++row) {
        const Point p = part.grid.cell_centre(row, 3);
        EXPECT_DOUBLE_EQ(part.at(row, 3), 3 * p.x - p.y);
    }
}

TEST(RasterWindow, ThinningAveragesBlocksWithoutShift) {
    const Raster part = raster_window(ramp(), ramp().grid.bounds(), 10);
    EXPECT_LE(part.grid.columns, 10);
    const Point p = part.grid.cell_centre(2, 3);
    EXPECT_NEAR(part.at(2, 3), 3 * p.x - p.y, 1e-9);  // the mean of a plane is its value in the middle
}

TEST(RasterWindow, WithoutOverlapIsEmpty) {
    EXPECT_EQ(raster_window(ramp(), {0, 0, 10, 10}, 100).grid.columns, 0);
}

TEST(RasterWindow, InterpolationIsExactOnAPlaneAndKeepsGaps) {
    Raster plane = ramp();
    EXPECT_NEAR(interpolated(plane, {133.3, 477.7}), 3 * 133.3 - 477.7, 1e-9);
    EXPECT_TRUE(std::isnan(interpolated(plane, {99, 477})));
    plane.at(10, 10) = k_no_data;
    EXPECT_TRUE(std::isnan(interpolated(plane, {120.5, 479.5})));
    const Point beside = plane.grid.cell_centre(10, 11);
    EXPECT_NEAR(interpolated(plane, beside), 3 * beside.x - beside.y,
                1e-9);  // a gap has no weight at a centre
}

TEST(RasterWindow, DataBoundsAndCells) {
    Raster raster(GridSpec{100, 500, 2, 40, 30, ""}, k_no_data);
    EXPECT_FALSE(data_bounds(raster));
    raster.at(3, 5) = 1;
    raster.at(7, 6) = 2;
    const Bounds box = *data_bounds(raster);
    EXPECT_EQ(box.west, 110);
    EXPECT_EQ(box.east, 114);
    EXPECT_EQ(box.north, 494);
    EXPECT_EQ(box.south, 484);
    EXPECT_EQ(cell_value(raster, {111.99, 492.01}), 1);
    EXPECT_TRUE(std::isnan(cell_value(raster, {112.01, 492.01})));
    EXPECT_TRUE(std::isnan(cell_value(raster, {1e9, 0})));
}

}  // namespace
}  // namespace frana::render
