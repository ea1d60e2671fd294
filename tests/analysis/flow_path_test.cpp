// SPDX-License-Identifier: Apache-2.0
#include "analysis/runout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace frana {
namespace {

Raster dry(std::int64_t columns, std::int64_t rows) {
    GridSpec grid;
    grid.north = static_cast<double>(rows);
    grid.columns = columns;
    grid.rows = rows;
    return Raster(grid, k_no_data);
}

TEST(FlowPath, OnOpenGroundIsAtMostEightPercentLongerThanTheLine) {
    // Uniform depth: all staircases of eight directions cost the same, 1 / cos(pi / 8) of the line at most.
    Raster depth = dry(100, 100);
    for (double& value : depth.values) value = 1;
    for (const double angle : {0.0, 0.2, 0.4, std::numbers::pi / 4}) {
        const Point from{5.5, 5.5}, to{5.5 + 80 * std::cos(angle), 5.5 + 80 * std::sin(angle)};
        const double found = length(flow_path(depth, from, to));
        EXPECT_GE(found, 80 - 1e-9) << angle;
        EXPECT_LE(found, 80 / std::cos(std::numbers::pi / 8) + 1) << angle;  // and to a cell's centre at the end
    }
}

TEST(FlowPath, FollowsTheDeepChannelAroundABend) {
    // A channel of 5 m depth: east along row 10, then south along column 40, in a film of 0.1 m.
    Raster depth = dry(60, 60);
    for (double& value : depth.values) value = 0.1;
    for (int column = 5; column <= 40; ++column) depth.at(10, column) = 5;
    for (int row = 10; row <= 50; ++row) depth.at(row, 40) = 5;
    const Point top = depth.grid.cell_centre(10, 5), tip = depth.grid.cell_centre(50, 40);
    const Polyline path = flow_path(depth, top, tip);
    // 35 cells and 40 cells; the straight line over the film would be 53. The corner may be cut: by a diagonal step, 2
    // - sqrt(2) cells shorter, and by the simplification to within a cell; 1.5 cells in all.
    EXPECT_NEAR(length(path), 75, 1.5);
    EXPECT_NEAR(path_coordinate(path, depth.grid.cell_centre(10, 20)), 15, 0.05);
    // Run-out of a mask that ends in row 30: 35 + 20.
    Raster mask = dry(60, 60);
    for (int row = 10; row <= 30; ++row) mask.at(row, 40) = 1;
    EXPECT_NEAR(runout_along(path, mask), 55, 1.5);
    EXPECT_EQ(runout_along(path, dry(60, 60)), 0);
}

TEST(FlowPath, VeryThinFilmsAreNoWall) {
    // Their costs were infinite: no path was found, and the search never ended.
    Raster depth = dry(40, 9);
    for (int column = 0; column < 40; ++column)
        if (column < 20 || column > 21) depth.at(4, column) = column % 2 == 0 ? 1e-320 : 1;
    const Polyline path = flow_path(depth, depth.grid.cell_centre(4, 0), depth.grid.cell_centre(4, 39));
    EXPECT_NEAR(length(path), 39, 1e-9);
}

TEST(FlowPath, LeavesTheFlowOnlyIfNecessary) {
    // Flow in columns 0-19 and 22-39 of one row: a gap of two dry cells lies between start and end.
    Raster depth = dry(40, 9);
    for (int column = 0; column < 40; ++column)
        if (column < 20 || column > 21) depth.at(4, column) = 1;
    const Polyline path = flow_path(depth, depth.grid.cell_centre(4, 0), depth.grid.cell_centre(4, 39));
    EXPECT_NEAR(length(path), 39, 1e-9);
    EXPECT_THROW(flow_path(depth, {-1, 4}, {3, 4}), Error);
    EXPECT_EQ(length(flow_path(depth, {0.2, 4.5}, {0.8, 4.5})), 0.8 - 0.2);  // one cell
}

TEST(Stations, AreEvenlySpacedAndIncludeTheVertices) {
    const std::vector<Station> list = stations({{0, 0}, {10, 0}, {10, 3}}, 4);
    ASSERT_EQ(list.size(), 5U);  // 0, 10/3, 20/3, 10, 13
    EXPECT_NEAR(list[1].distance, 10.0 / 3, 1e-12);
    EXPECT_EQ(list[3].place.x, 10);
    EXPECT_EQ(list[4].distance, 13);
    EXPECT_EQ(list[4].place.y, 3);
}

TEST(CellValue, IsThatOfTheCellAndNanOutside) {
    Raster raster = dry(2, 2);
    raster.at(0, 1) = 7;
    EXPECT_EQ(cell_value(raster, {1.01, 1.99}), 7);
    EXPECT_TRUE(std::isnan(cell_value(raster, {2.01, 1})));
}

}  // namespace
}  // namespace frana
