// SPDX-License-Identifier: Apache-2.0
#include "analysis/slip_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"

namespace frana {
namespace {

GridSpec grid_of(double cell) {
    const auto count = static_cast<std::int64_t>(400 / cell);
    return {1000, 2400, cell, count, count, ""};
}

Raster plane(double cell) {
    Raster raster(grid_of(cell));
    for (std::int64_t r = 0; r < raster.grid.rows; ++r) {
        for (std::int64_t c = 0; c < raster.grid.columns; ++c) {
            const Point p = raster.grid.cell_centre(r, c);
            raster.at(r, c) = 500 - 0.4 * (p.x - 1000) + 0.1 * (p.y - 2000);
        }
    }
    return raster;
}

MultiPolygon ellipse(double a, double b, double turn) {
    Ring ring;
    for (int i = 0; i < 720; ++i) {
        const double t = i * std::numbers::pi / 360;
        const double x = a * std::cos(t), y = b * std::sin(t);
        ring.push_back(
            {1200 + x * std::cos(turn) - y * std::sin(turn), 2200 + x * std::sin(turn) + y * std::cos(turn)});
    }
    return {{ring, {}}};
}

// IAEG (1990): half an ellipsoid, 2/3 pi a b D.
TEST(SlipSurface, IsHalfAnEllipsoidUnderAnEllipseOnAPlane) {
    const double a = 120, b = 50, depth = 14;
    double before = 0;
    for (const double cell : {4.0, 2.0}) {
        const Raster ground = plane(cell);
        const SlipSurface slip(ground, ellipse(a, b, 0.5));
        EXPECT_EQ(slip.shape(), SlipShape::ellipsoid);
        const double exact = 2.0 / 3 * std::numbers::pi * a * b * depth;
        const double error = std::abs(slip.volume(depth) / exact - 1);
        // The edge is vertical: summing cells by their centres has an error of the order of cell / b there.
        EXPECT_LT(error, 0.1 * cell / b);
        if (before > 0) {
            EXPECT_LT(error, before);
        }
        before = error;
        const Raster thickness = slip.thickness(depth);
        for (std::int64_t r = 0; r < ground.grid.rows; ++r) {
            for (std::int64_t c = 0; c < ground.grid.columns; ++c) {
                const Point p = ground.grid.cell_centre(r, c);
                const double x = (p.x - 1200) * std::cos(0.5) + (p.y - 2200) * std::sin(0.5),
                             y = -(p.x - 1200) * std::sin(0.5) + (p.y - 2200) * std::cos(0.5);
                const double left = 1 - x * x / (a * a) - y * y / (b * b);
                if (std::abs(left) < 1e-3) continue;  // the 720 corners are only approximately the ellipse
                // The polygon's edges are up to a (pi / 720)^2 / 2 inside the ellipse: 1e-5 of the radius.
                EXPECT_NEAR(thickness.at(r, c), depth * std::sqrt(std::max(0.0, left)), 2e-3 * depth);
            }
        }
    }
}

TEST(SlipSurface, MatchesAGivenVolume) {
    const Raster ground = plane(4);
    const SlipSurface slip(ground, ellipse(100, 60, 0));
    EXPECT_NEAR(slip.volume(slip.depth_for(1e5)), 1e5, 1e-3);
}

// Constant curvature on a rectangle far longer than wide: a parabola over its width, greatest in the middle; mean over
// the middle section two thirds of it. A second, small part is why no ellipsoid fits.
TEST(SlipSurface, FallsBackToTheBaseLevelOfConstantCurvature) {
    const Raster ground = plane(2);
    const MultiPolygon strip{{{{1040, 2180}, {1360, 2180}, {1360, 2220}, {1040, 2220}}, {}},
                             {{{1040, 2280}, {1050, 2280}, {1050, 2290}, {1040, 2290}}, {}}};
    const SlipSurface slip(ground, strip);
    EXPECT_EQ(slip.shape(), SlipShape::base_level);
    const Raster thickness = slip.thickness(10);
    const std::int64_t column = 100;  // the middle
    double largest = 0;
    for (std::int64_t r = 0; r < ground.grid.rows; ++r) {
        const double y = ground.grid.cell_centre(r, column).y - 2200;
        // The surface is zero at the centres of the first cells outside, 21 m from the middle line.
        const double exact = std::abs(y) < 20 ? 10 * (1 - y * y / (21 * 21)) : 0;
        // With an even number of rows none is in the middle; the highest, scaled to 10, is 1 m beside it.
        EXPECT_NEAR(thickness.at(r, column), exact, 0.03) << y;
        largest = std::max(largest, thickness.at(r, column));
    }
    EXPECT_NEAR(largest, 10, 1e-9);
}

TEST(SlipSurface, DetectsThePerimetersThatAnEllipsoidFits) {
    const MultiPolygon crescent{
        {{{1100, 2100}, {1300, 2100}, {1300, 2300}, {1280, 2300}, {1280, 2120}, {1100, 2120}}, {}}};
    EXPECT_TRUE(visible_from_centroid(ellipse(50, 20, 1)));
    EXPECT_FALSE(visible_from_centroid(crescent));
    const Raster ground = plane(4);
    EXPECT_EQ(SlipSurface(ground, crescent).shape(), SlipShape::base_level);
    EXPECT_THROW(SlipSurface(ground, ellipse(1, 1, 0)), Error);     // no cell's centre inside
    EXPECT_THROW(SlipSurface(ground, ellipse(230, 20, 0)), Error);  // beyond the ground
}

}  // namespace
}  // namespace frana
