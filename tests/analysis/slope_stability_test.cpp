// SPDX-License-Identifier: Apache-2.0
#include "analysis/slope_stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace frana {
namespace {

constexpr double k_radians = std::numbers::pi / 180;

/// Ground of 40 x 40 cells of 5 m; coordinates eastwards and southwards from its north-western corner.
Raster sloping_ground(const std::function<double(double x, double y)>& elevation) {
    GridSpec grid;
    grid.north = 200;
    grid.cell_size = 5;
    grid.columns = grid.rows = 40;
    Raster raster(grid);
    for (std::int64_t row = 0; row < 40; ++row)
        for (std::int64_t column = 0; column < 40; ++column)
            raster.at(row, column) =
                elevation(5 * (static_cast<double>(column) + 0.5), 5 * (static_cast<double>(row) + 0.5));
    return raster;
}

/// A plane that falls to the south-east.
Raster inclined(double slope_deg) {
    const double tangent = std::tan(slope_deg * k_radians);
    return sloping_ground([=](double x, double y) { return 1000 - tangent * (0.6 * x + 0.8 * y); });
}

SlopeScreening screened(const Raster& terrain, const SlopeLayer& layer, const StartingGround& limits = {}) {
    return screen_slopes(terrain, limits, [&](std::size_t) { return layer; });
}

// Dry sand: tan(phi) / tan(s). Saturated: times the buoyant over the whole density. Cohesion adds 2 c / (rho g d
// sin(2 s)). Differences of elevations of 1000 m are exact to 1e-13 m, of 20 to 90 m to some 1e-14.
TEST(SlopeStability, FactorsOnPlanesAreThoseOfTheClosedForm) {
    const double phi = 32;
    for (const double slope : {7.0, 18.0, 31.0, 44.0, 62.0}) {
        const double dry = std::tan(phi * k_radians) / std::tan(slope * k_radians);
        const double bond = 2 * 4000 / (1900 * 9.81 * 1.5 * std::sin(2 * slope * k_radians));
        const std::pair<SlopeLayer, double> cases[] = {
            {{0, phi, 1.5, 0, 1900}, dry},
            {{0, phi, 1.5, 1, 1900}, dry * 900 / 1900},
            {{0, phi, 1.5, 0.4, 1900}, dry * 1500 / 1900},
            {{4000, phi, 1.5, 0, 1900}, dry + bond},
            {{4000, 0, 1.5, 1, 1900}, bond},
            {{4000, phi, 1.5, 1, 1900}, dry * 900 / 1900 + bond},
        };
        const Raster terrain = inclined(slope);
        for (const auto& [layer, expected] : cases) {
            const SlopeScreening found = screened(terrain, layer);
            EXPECT_NEAR(found.factor.at(20, 13), std::min(expected, k_most_factor), 1e-11 * expected) << slope;
            EXPECT_EQ(found.starts.at(20, 13), expected < 1 ? 1 : 0) << slope;
        }
    }
}

// Ground that steepens with x: z = 500 - x^2 / 400, whose slope at the centre of a cell is x / 200 exactly by central
// differences. Saturated, without cohesion, the critical tangent is tan(phi) (rho - rho_w) / rho.
TEST(SlopeStability, TheCriticalSlopeIsFoundWithinACell) {
    const Raster terrain = sloping_ground([](double x, double) { return 500 - x * x / 400; });
    for (const double saturation : {0.0, 0.5, 1.0}) {
        const SlopeScreening found = screened(terrain, {0, 35, 1, saturation, 2000});
        const double critical = 200 * std::tan(35 * k_radians) * (1 - saturation / 2);
        int first = 1;
        while (first < 39 && found.starts.at(20, first) == 0) ++first;
        EXPECT_NEAR(5 * (first + 0.5), critical + 2.5, 2.5) << saturation;
        for (int column = 1; column < 39; ++column) EXPECT_EQ(found.starts.at(20, column), column >= first ? 1 : 0);
        EXPECT_EQ(found.starts.at(20, 0), 0) << "the edge has no slope";
        EXPECT_TRUE(std::isnan(found.factor.at(0, 20)));
    }
}

TEST(SlopeStability, LevelGroundStandsAndMatterThatFloatsHasNoFriction) {
    const Raster level = sloping_ground([](double, double) { return 10; });
    EXPECT_EQ(screened(level, {0, 30, 1, 0, 2000}).factor.at(9, 9), k_most_factor);
    EXPECT_EQ(factor_of_safety({0, 30, 1, 1, 300}, 20), 0);
    EXPECT_TRUE(std::isnan(factor_of_safety({0, 30, k_no_data, 1, 300}, 20)));
    EXPECT_TRUE(std::isnan(factor_of_safety({0, 30, 1, k_no_data, 300}, 20)));
    const SlopeScreening none = screened(inclined(40), {0, 30, k_no_data, 0, 2000});
    EXPECT_TRUE(std::isnan(none.factor.at(9, 9)));
    EXPECT_EQ(none.starts.at(9, 9), 0);
}

// Matter without strength fails everywhere, so the limits alone decide, as in screenings of avalanches: the slope, both
// limits included, and no ridge. Ridge and gully z = 400 - x -+ (y - 100)^2 / 80 bend by 1/40 across the slope at y =
// 100.
TEST(SlopeStability, LimitsOfSlopeAndConvexity) {
    const auto starts = [](const Raster& terrain, const StartingGround& limits) {
        return screened(terrain, {0, 0, 1, 0, 2000}, limits).starts.at(20, 20);
    };
    EXPECT_EQ(starts(inclined(30), {28, 55}), 1);
    EXPECT_EQ(starts(inclined(27), {28, 55}), 0);
    EXPECT_EQ(starts(inclined(56), {28, 55}), 0);
    EXPECT_EQ(screened(inclined(30), {0, 0, k_no_data, 0, 2000}, {28, 55}).starts.at(20, 20), 0);
    EXPECT_EQ(screened(inclined(30), {0, 0, 0, 0, 2000}, {28, 55}).starts.at(20, 20), 0);
    const Raster ridge = sloping_ground([](double x, double y) { return 400 - x - (y - 102.5) * (y - 102.5) / 80; });
    const Raster gully = sloping_ground([](double x, double y) { return 400 - x + (y - 102.5) * (y - 102.5) / 80; });
    EXPECT_EQ(starts(ridge, {28, 55, 0.0251}), 1);
    EXPECT_EQ(starts(ridge, {28, 55, 0.0249}), 0);
    EXPECT_EQ(starts(gully, {28, 55, 0.0249}), 1);
    EXPECT_EQ(starts(ridge, {28, 55}), 1);
}

}  // namespace
}  // namespace frana
