// SPDX-License-Identifier: Apache-2.0
#include "render/map/hillshade.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frana::render {
namespace {

/// A plane rising by `to_east` and `to_north`.
Raster plane(double to_east, double to_north) {
    Raster raster(GridSpec{0, 90, 10, 9, 9, ""});
    for (std::int64_t row = 0; row < 9; ++row) {
        for (std::int64_t column = 0; column < 9; ++column) {
            const Point p = raster.grid.cell_centre(row, column);
            raster.at(row, column) = to_east * p.x + to_north * p.y;
        }
    }
    return raster;
}

TEST(Hillshade, SlopesTowardsTheNorthWestAreBrightest) {
    const double level = hillshade(plane(0, 0)).at(4, 4);
    const double north_west = hillshade(plane(0.4, -0.4)).at(4, 4);
    const double south_east = hillshade(plane(-0.4, 0.4)).at(4, 4);
    const double north_east = hillshade(plane(-0.4, -0.4)).at(4, 4);
    EXPECT_GT(north_west, level);
    EXPECT_LT(south_east, level);
    EXPECT_LT(south_east, north_east);
    EXPECT_GT(south_east, 0.05);  // several lights: no slope of this steepness is black
}

TEST(Hillshade, ScaleAndEdgesDoNotMatterOnAPlane) {
    const Raster shade = hillshade(plane(0.3, 0.2));
    for (const double value : shade.values) EXPECT_NEAR(value, shade.at(4, 4), 1e-12);
}

TEST(Hillshade, GapsStayGapsAndDoNotSpread) {
    Raster ground = plane(0.3, 0.2);
    ground.at(4, 4) = k_no_data;
    const Raster shade = hillshade(ground);
    int gaps = 0;
    for (const double value : shade.values) {
        if (std::isnan(value)) {
            ++gaps;
        } else {
            EXPECT_NEAR(value, shade.at(0, 0), 1e-12);
        }
    }
    EXPECT_EQ(gaps, 1);
}

}  // namespace
}  // namespace frana::render
