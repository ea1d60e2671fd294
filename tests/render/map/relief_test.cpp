// SPDX-License-Identifier: Apache-2.0
#include "render/map/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

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

TEST(Contours, OfAConeAreClosedCirclesOfTheRightRadius) {
    Raster cone(GridSpec{1000, 2000, 2, 101, 101, ""});
    const Point peak{1101, 1899};
    for (std::int64_t row = 0; row < 101; ++row) {
        for (std::int64_t column = 0; column < 101; ++column) {
            const Point p = cone.grid.cell_centre(row, column);
            cone.at(row, column) = 95 - std::hypot(p.x - peak.x, p.y - peak.y);
        }
    }
    std::map<double, int> lines;
    for (const Contour& contour : contour_lines(cone, 20)) {
        ++lines[contour.level];
        if (contour.level < 0) continue;  // cut by the edge
        EXPECT_EQ(contour.points.front().x, contour.points.back().x);
        EXPECT_EQ(contour.points.front().y, contour.points.back().y);
        for (const Point p : contour.points) {
            // A cone is not straight between centres: over 2 m at radius r the arc bulges by at most 2 * 2 /
            // (8 r).
            EXPECT_NEAR(std::hypot(p.x - peak.x, p.y - peak.y), 95 - contour.level, 4.0 / (8 * 15) + 1e-9);
        }
    }
    for (const double level : {0.0, 20.0, 40.0, 60.0, 80.0}) EXPECT_EQ(lines[level], 1) << level;
}

TEST(Contours, GapsInterruptAndPlanesGiveStraightLines) {
    Raster plane(GridSpec{0, 100, 1, 100, 100, ""});
    for (std::int64_t row = 0; row < 100; ++row) {
        for (std::int64_t column = 0; column < 100; ++column) plane.at(row, column) = static_cast<double>(column) + 0.5;
    }
    plane.at(50, 40) = k_no_data;
    int pieces = 0;
    for (const Contour& contour : contour_lines(plane, 10)) {
        for (const Point p : contour.points) EXPECT_NEAR(p.x, contour.level, 1e-5);  // VTK has floats, of up to 100
        if (contour.level == 40) ++pieces;
    }
    EXPECT_EQ(pieces, 2);  // above and below the gap
}

TEST(Contours, NothingOnLevelGround) {
    EXPECT_TRUE(contour_lines(Raster(GridSpec{0, 9, 1, 9, 9, ""}, 5), 10).empty());
}

}  // namespace

}  // namespace frana::render
