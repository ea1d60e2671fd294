// SPDX-License-Identifier: Apache-2.0
// Classes of terrain and the friction of a table, on surfaces whose curvature is known.
#include "analysis/friction_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace frana {
namespace {

constexpr std::int64_t k_side = 41, k_middle = 20;
constexpr double k_cell = 5;

/// Elevations as a function of the distance from the middle cell, eastwards and northwards.
Raster surface(const std::function<double(double, double)>& elevation, double cell = k_cell) {
    GridSpec grid;
    grid.cell_size = cell;
    grid.columns = grid.rows = k_side;
    Raster raster(grid);
    for (std::int64_t row = 0; row < k_side; ++row)
        for (std::int64_t column = 0; column < k_side; ++column)
            raster.at(row, column) =
                elevation(static_cast<double>(column - k_middle) * cell, static_cast<double>(k_middle - row) * cell);
    return raster;
}

/// Two volumes, two bands, four classes; mu = 0.1 class + 0.01 band + 0.001 volume, xi = 1000 (class + 1).
FrictionChoice choice(double volume = 100) {
    FrictionTable table{.name = "own"};
    table.periods = {30};
    table.volumes = {1000};
    table.altitudes = {1500};
    table.terrain = {{"flat", 0}, {"open", 0.002}, {"channelled", 0.01}, {"gully", 0.05}};
    table.spacing = 10;
    table.forest = FrictionTable::Forest{0.05, 400};
    for (int v = 0; v < 2; ++v)
        for (int kind = 0; kind < 4; ++kind)
            for (int band = 0; band < 2; ++band)
                table.values.push_back({0.1 * kind + 0.01 * band + 0.001 * v, 1000.0 * (kind + 1)});
    return {.table = table, .volume = volume};
}

FrictionByPlace::Place middle(const Raster& terrain, FrictionChoice chosen = choice()) {
    return FrictionByPlace(std::move(chosen), terrain, std::nullopt).at(k_middle, k_middle).value();
}

// Parabolas, which the fitted one reproduces: exact but for rounding. Each is turned by all angles.
TEST(CurvatureAcrossSlope, OfSecondDegreeSurfacesIsExact) {
    constexpr double k_slope = 0.6;
    for (int degrees = 0; degrees < 360; degrees += 15) {
        const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
        for (const double across : {-0.03, 0.0, 0.002, 0.01, 0.05}) {
            // Curvature along the slope does not count.
            const Raster ground = surface([&](double x, double y) {
                const double along = c * x + s * y, side = c * y - s * x;
                return 1000 - k_slope * along + 0.5 * 0.004 * along * along + 0.5 * across * side * side;
            });
            EXPECT_NEAR(ground_shape(ground, k_middle, k_middle, 2).curvature, across, 1e-12) << degrees;
        }
    }
}

TEST(CurvatureAcrossSlope, OfAPlaneIsZeroOnAnySpacing) {
    const Raster plane = surface([](double x, double y) { return 900 - 0.5 * x + 0.2 * y; });
    for (const std::int64_t step : {1, 2, 5}) EXPECT_NEAR(ground_shape(plane, 20, 20, step).curvature, 0, 1e-13);
}

// |y| of slope b across, a along: at the thalweg 2 b / h for elevations h apart, as the second difference of |y| says.
TEST(CurvatureAcrossSlope, OfAVShapedValleyIsThatOfItsChord) {
    const Raster valley = surface([](double x, double y) { return 900 - 0.5 * x + 0.4 * std::abs(y); });
    EXPECT_NEAR(ground_shape(valley, k_middle, k_middle, 2).curvature, 2 * 0.4 / 10, 1e-12);
    EXPECT_NEAR(ground_shape(valley, k_middle - 2, k_middle, 2).curvature, 0, 1e-12) << "its sides are planes";
    const Raster ridge = surface([](double x, double y) { return 900 - 0.5 * x - 0.4 * std::abs(y); });
    EXPECT_NEAR(ground_shape(ridge, k_middle, k_middle, 2).curvature, -0.08, 1e-12);
}

// On a cone of slope k the contour is a circle: k / r inwards, -k / r outwards. The fit sees it to (h / r)^2.
TEST(CurvatureAcrossSlope, OfAConeIsThatOfItsContour) {
    for (const double r : {60.0, 90.0}) {
        const auto cone = [r](double sign) {
            return surface([=](double x, double y) { return 900 + sign * 0.5 * std::hypot(x - r, y); });
        };
        EXPECT_NEAR(ground_shape(cone(1), 20, 20, 2).curvature, 0.5 / r, 0.5 / r * (100 / (r * r))) << "funnel";
        EXPECT_NEAR(ground_shape(cone(-1), 20, 20, 2).curvature, -0.5 / r, 0.5 / r * (100 / (r * r))) << "fan";
    }
}

TEST(CurvatureAcrossSlope, FadesOutInFlatGroundAndIsZeroAtTheEdge) {
    const auto channel = [](double slope) {
        return surface([slope](double x, double y) { return 900 - slope * x + 0.5 * 0.05 * y * y; });
    };
    EXPECT_NEAR(ground_shape(channel(0.1), 20, 20, 2).curvature, 0.05, 1e-12);
    EXPECT_NEAR(ground_shape(channel(0.05), 20, 20, 2).curvature, 0.05 / 4, 1e-12);
    EXPECT_EQ(ground_shape(channel(0), 20, 20, 2).curvature, 0);
    Raster holed = channel(0.5);
    EXPECT_EQ(ground_shape(holed, 1, 20, 2).curvature, 0);
    EXPECT_EQ(ground_shape(holed, 20, 39, 2).curvature, 0);
    holed.at(18, 22) = k_no_data;
    EXPECT_EQ(ground_shape(holed, 20, 20, 2).curvature, 0);
}

Raster channel_of(double curvature) {
    return surface([=](double x, double y) { return 900 - 0.5 * x + 0.5 * curvature * y * y; });
}

TEST(FrictionByPlace, HasTheValuesOfAClassAtItsCurvatureAndBeyond) {
    const std::vector<std::pair<double, std::size_t>> expected{{-0.03, 0}, {0, 0}, {0.0505, 3}, {0.2, 3}};
    for (const auto& [curvature, kind] : expected) {
        const auto place = middle(channel_of(curvature));
        EXPECT_EQ(place.kind, kind) << curvature;
        EXPECT_NEAR(place.values.coefficient, 0.1 * static_cast<double>(kind), 1e-10) << curvature;
        EXPECT_NEAR(place.values.turbulence, 1000.0 * static_cast<double>(kind + 1), 1e-6) << curvature;
    }
    EXPECT_EQ(middle(surface([](double x, double) { return 900 - 0.6 * x; })).kind, 0U) << "a plane";
    EXPECT_EQ(middle(surface([](double x, double y) { return 900 - 0.5 * x + 0.4 * std::abs(y); })).kind, 3U);
    EXPECT_EQ(middle(surface([](double x, double y) { return 900 - 0.5 * x - 0.4 * std::abs(y); })).kind, 0U);
}

// Half way in curvature: mu half way, 1/xi half way.
TEST(FrictionByPlace, IsLinearInCurvatureBetweenTwoClasses) {
    const auto place = middle(channel_of(0.006));
    EXPECT_NEAR(place.values.coefficient, 0.15, 1e-9);
    EXPECT_NEAR(place.values.turbulence, 2 / (1 / 2000.0 + 1 / 3000.0), 1e-6);
    EXPECT_EQ(middle(channel_of(0.0059)).kind, 1U);
    EXPECT_EQ(middle(channel_of(0.0061)).kind, 2U);
    EXPECT_EQ(middle(channel_of(0.0299)).kind, 2U);
    EXPECT_EQ(middle(channel_of(0.0301)).kind, 3U);
}

// A first class by slope takes all ground less steep, whatever its curvature; the others stay as they are.
TEST(FrictionByPlace, TakesGentleGroundByItsSlope) {
    FrictionChoice gentle = choice();
    FrictionTable& table = gentle.table;
    table.terrain[0].slope_below = 10;
    const auto at = [&](double slope, double curvature) {
        const Raster ground = surface([=](double x, double y) { return 900 - slope * x + 0.5 * curvature * y * y; });
        return FrictionByPlace(gentle, ground, std::nullopt).at(k_middle, k_middle).value();
    };
    for (const double curvature : {-0.03, 0.0, 0.01, 0.05}) {
        EXPECT_EQ(at(0.17, curvature).kind, 0U) << "9.6 degrees, " << curvature;
        EXPECT_EQ(at(0.17, curvature).values.coefficient, table.at(0, 0, 0, 0).coefficient);
    }
    EXPECT_EQ(at(0.18, 0).kind, 1U) << "10.2 degrees";
    EXPECT_EQ(at(0.18, 0).values.coefficient, table.at(0, 0, 1, 0).coefficient);
    EXPECT_EQ(at(0.5, 0.2).kind, 3U);
    EXPECT_NEAR(at(0.5, 0.006).values.coefficient, 0.15, 1e-9);
}

// 1000 m3 within 5 % of the volume.
TEST(FrictionChoice, KnowsWhenTheOtherClassOfVolumeIsAsLikely) {
    EXPECT_EQ(choice(953).close_class(), 1U);
    EXPECT_EQ(choice(1052).close_class(), 0U);
    EXPECT_FALSE(choice(952).close_class());
    EXPECT_FALSE(choice(1053).close_class());
}

// The spacing of the elevations is the table's, whatever the cells.
TEST(FrictionByPlace, DoesNotFollowTheCellSize) {
    const auto bumpy = [](double x, double y) { return 900 - 0.5 * x + 0.4 * std::abs(y); };
    for (const double cell : {2.5, 5.0, 10.0})
        EXPECT_NEAR(middle(surface(bumpy, cell)).values.coefficient, 0.3, 1e-9) << cell;
}

TEST(FrictionByPlace, TakesBandVolumeForestAndFactors) {
    const Raster ground = surface([](double x, double) { return 1500 - 0.5 * x; });
    Raster forest(ground.grid, k_no_data);
    forest.at(k_middle, k_middle + 1) = 1;
    FrictionChoice large = choice(1000);  // a value on a limit belongs to the upper class
    large.friction_factor = 2;
    large.turbulence_factor = 0.5;
    const FrictionByPlace friction(large, ground, forest);
    const auto at = [&](std::int64_t column) { return friction.at(k_middle, column).value(); };
    EXPECT_EQ(at(k_middle).band, 1U) << "1500 m is above the limit of 1500";
    EXPECT_EQ(at(k_middle + 1).band, 0U);
    EXPECT_NEAR(at(k_middle).values.coefficient, 2 * 0.011, 1e-12);
    EXPECT_NEAR(at(k_middle).values.turbulence, 500, 1e-9);
    EXPECT_TRUE(at(k_middle + 1).forest);
    EXPECT_NEAR(at(k_middle + 1).values.coefficient, 2 * (0.001 + 0.05), 1e-12);
    EXPECT_NEAR(at(k_middle + 1).values.turbulence, 200, 1e-9);
    Raster holed = ground;
    holed.at(3, 3) = k_no_data;
    EXPECT_FALSE(FrictionByPlace(large, holed, std::nullopt).at(3, 3));
}

TEST(FrictionAreas, CountTheMarkedCellsOfAPartOfTheGround) {
    const Raster ground = surface([](double x, double) { return 1500 - 0.5 * x; });
    const FrictionByPlace friction(choice(), ground, std::nullopt);
    // The middle row, from two cells west of the middle to three east of it: three cells at 1500 m or above.
    Raster mask = part_of(Raster(ground.grid), CellWindow{k_middle, k_middle - 2, 1, 6});
    for (std::int64_t column = 0; column < 6; ++column) mask.at(0, column) = 1;
    const std::vector<FrictionArea> areas = friction_areas(friction, mask);
    ASSERT_EQ(areas.size(), 2U);
    EXPECT_EQ(areas[0].band, 0U);
    EXPECT_EQ(areas[0].area_m2, 3 * k_cell * k_cell);
    EXPECT_EQ(areas[1].area_m2, 3 * k_cell * k_cell);
}

}  // namespace
}  // namespace frana
