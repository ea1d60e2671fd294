// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace frana::gis {
namespace {

// Seven-digit coordinates, as on real maps.
const GridSpec k_grid{527000, 5095000, 5, 20, 12, ""};

Polygon square_with_hole() {
    const auto at = [](double x, double y) { return Point{527000 + x, 5095000 - y}; };
    return {{at(9, 9), at(61, 9), at(61, 41), at(9, 41)}, {{at(19, 19), at(31, 19), at(31, 31), at(19, 31)}}};
}

double sum(const Raster& raster) {
    return std::accumulate(raster.values.begin(), raster.values.end(), 0.0);
}

TEST(Coverage, CountsCellCentresAndRespectsHoles) {
    const MultiPolygon polygons{square_with_hole()};
    const Raster mask = coverage(polygons, k_grid);
    for (int row = 0; row < k_grid.rows; ++row) {
        for (int column = 0; column < k_grid.columns; ++column) {
            ASSERT_EQ(mask.at(row, column), contains(polygons, k_grid.cell_centre(row, column)) ? 1 : 0)
                << row << " " << column;
        }
    }
    EXPECT_EQ(sum(mask), 10 * 6 - 2 * 2);
    EXPECT_EQ(sum(coverage({}, k_grid)), 0);
    EXPECT_EQ(sum(coverage({{{{0, 0}, {1, 0}, {1, 1}}, {}}}, k_grid)), 0) << "far away";
}

TEST(Polygonise, ReturnsExactlyTheCells) {
    const Raster mask = coverage({square_with_hole()}, k_grid);
    const MultiPolygon outlines = polygonise(mask);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].holes.size(), 1U);
    EXPECT_DOUBLE_EQ(area(outlines), (10 * 6 - 2 * 2) * 25.0);
    EXPECT_EQ(coverage(outlines, k_grid).values, mask.values);
    const Bounds box = bounds(outlines);
    EXPECT_EQ(box.west, 527010);
    EXPECT_EQ(box.north, 5094990);
}

TEST(Polygonise, CornersDoNotJoinAndNoDataIsOutside) {
    Raster mask(k_grid, 0.0);
    mask.at(2, 2) = mask.at(3, 3) = 0.7;
    mask.at(5, 5) = k_no_data;
    EXPECT_EQ(polygonise(mask).size(), 2U);
    EXPECT_TRUE(polygonise(Raster(k_grid, 0.0)).empty());
}

}  // namespace
}  // namespace frana::gis
