// SPDX-License-Identifier: Apache-2.0
#include "analysis/convergence.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace frana {
namespace {

// f(h) = scale (10 + 3 h^p) has order p and limit 10 scale exactly.
std::vector<Refinement> power_law(double order, double scale = 1, const std::vector<double>& sizes = {8, 4, 2}) {
    std::vector<Refinement> levels;
    for (const double h : sizes) levels.push_back({h, scale * (10 + 3 * std::pow(h, order))});
    return levels;
}

// On cells as numerics.accuracy makes them.
const std::vector<double> k_close{12, 8, 6, 4, 3, 2};

GridConvergence of_one(const std::vector<Refinement>& levels, double detail = 0) {
    return grid_convergence({levels}, detail).front();
}

TEST(GridConvergence, RecoversOrderAndLimitOfAPowerLaw) {
    for (const double order : {0.6, 1.0, 1.7}) {
        for (const auto& levels : {power_law(order), power_law(order, 1, k_close)}) {
            const GridConvergence c = of_one(levels);
            EXPECT_EQ(c.trend, Trend::converging);
            EXPECT_NEAR(c.observed_order, order, 1e-12);
            EXPECT_NEAR(c.extrapolated, 10, 1e-10);
        }
    }
}

TEST(GridConvergence, OfFirstOrderIsTheTrueErrorTimesTheSafetyFactor) {
    for (const auto& levels : {power_law(1), power_law(1, 1, k_close)}) {
        const GridConvergence c = of_one(levels);
        EXPECT_NEAR(c.error, 1.25 * 3 * 2, 1e-9);
        EXPECT_NEAR(c.index_percent, 100 * c.error / 16, 1e-9);
    }
}

TEST(GridConvergence, TakesTheGreaterChangeOfTheTwoRanges) {
    // Order two: f(8) - f(2) = 180 and f(4) - f(2) = 36; first order would leave a third of the one.
    EXPECT_NEAR(of_one(power_law(2)).error, 1.25 * 60, 1e-9);
    // Order 0.6: |f(4) - f(2)| is more than a third of |f(8) - f(2)|.
    EXPECT_NEAR(of_one(power_law(0.6)).error, 1.25 * 3 * (std::pow(4, 0.6) - std::pow(2, 0.6)), 1e-9);
    // Two equal values by chance among others that are not.
    const GridConvergence chance = of_one({{8, 4}, {6, 13}, {4, 10}, {3, 10}, {2, 10}});
    EXPECT_EQ(chance.trend, Trend::oscillating);
    EXPECT_NEAR(chance.error, 1.25 * (13 - 4) / 3.0, 1e-12);
}

TEST(GridConvergence, HasNoOrderAboveTheSchemes) {
    const GridConvergence two = of_one(power_law(2)), fast = of_one(power_law(2.8));
    EXPECT_NEAR(two.extrapolated, 10, 1e-10);
    EXPECT_EQ(fast.trend, Trend::converging);
    EXPECT_TRUE(std::isnan(fast.observed_order));
    EXPECT_EQ(fast.extrapolated, power_law(2.8).back().value);
}

TEST(GridConvergence, SaysWhereValuesDoNotConverge) {
    const GridConvergence swing = of_one({{8, 10}, {4, 12}, {2, 11}});
    EXPECT_EQ(swing.trend, Trend::oscillating);
    EXPECT_TRUE(std::isnan(swing.observed_order));
    EXPECT_EQ(swing.extrapolated, 11);
    EXPECT_NEAR(swing.error, 1.25, 1e-12);
    const GridConvergence away = of_one({{8, 10}, {4, 11}, {2, 13}});
    EXPECT_EQ(away.trend, Trend::diverging);
    EXPECT_TRUE(std::isinf(away.error)) << "changes that grow bound nothing";
    for (const double last : {1.0, 0.999, 0.95}) {  // with each halving about as much again: there is no limit
        const GridConvergence equal = of_one({{8, 10}, {4, 11}, {2, 11 + last}});
        EXPECT_EQ(equal.trend, Trend::diverging) << last;
        EXPECT_TRUE(std::isinf(equal.error)) << last;
    }
    EXPECT_EQ(of_one({{8, 10}, {4, 11}, {2, 11.8}}).trend, Trend::converging);
    EXPECT_EQ(of_one({{8, 18}, {4, 14}, {3, 15}, {2, 12}}).trend, Trend::oscillating);  // one level between that swings
    EXPECT_EQ(of_one({{4, 14}, {3, 13}, {2, 12}}).trend, Trend::unknown);
}

// Changes of 10 %, 0.4 % and none, whose median is 0.4 %, each by first order.
TEST(GridConvergence, DrawsEachErrorTowardsThoseOfTheOthers) {
    const auto changing = [](double percent) {
        std::vector<Refinement> levels;
        for (const double h : {8.0, 4.0, 2.0}) levels.push_back({h, 50 * (1 + percent / 100 * (h - 2) / 2)});
        return levels;
    };
    const auto errors = grid_convergence({changing(10), changing(0.4), changing(0)}, 0);
    EXPECT_NEAR(errors[0].index_percent, 1.25 * std::sqrt(10 * 0.4), 1e-9);
    EXPECT_NEAR(errors[1].index_percent, 1.25 * 0.4, 1e-9);
    EXPECT_NEAR(errors[2].index_percent, 1.25 * std::sqrt(0.04 * 0.4), 1e-9);  // equal by chance: a tenth of the median
    EXPECT_EQ(errors[2].trend, Trend::settled);
    // A value that is zero on the finest has no relative change, and does not count for the others.
    const auto zero = grid_convergence({changing(10), changing(0.4), changing(0), {{8, 3}, {4, 1}, {2, 0}}}, 0);
    EXPECT_NEAR(zero[3].error, 1.25 * 1, 1e-12);
    EXPECT_EQ(zero[0].error, errors[0].error);
    for (const GridConvergence& none : grid_convergence({changing(0), changing(0)}, 9)) EXPECT_EQ(none.error, 0);
}

TEST(GridConvergence, ExpectsWhatTheTerrainStillHides) {
    const GridConvergence rough = of_one(power_law(1), 4);
    EXPECT_EQ(rough.trend, Trend::terrain);
    EXPECT_NEAR(rough.error, 2 * 1.25 * 6, 1e-9);  // by the root of it
    EXPECT_EQ(of_one(power_law(1), 1).trend, Trend::converging);
    EXPECT_NEAR(of_one(power_law(1), 0.5).error, 1.25 * 6, 1e-9);
}

TEST(GridConvergence, NeedsThreeLevels) {
    EXPECT_THROW(of_one({{4, 1}, {2, 2}}), Error);
}

TEST(GridConvergence, NeedsThreeOfWhichOneIsTwiceTheFinest) {
    EXPECT_TRUE(enough_levels({8, 4, 2}));
    EXPECT_TRUE(enough_levels({12, 8, 6, 4, 3, 2}));
    EXPECT_FALSE(enough_levels({4, 3, 2})) << "no trend can be told";
    EXPECT_FALSE(enough_levels({4, 2}));
    EXPECT_FALSE(enough_levels({12, 9, 3}));
    EXPECT_FALSE(enough_levels({}));
}

TEST(TerrainDetail, IsWhatCurvatureGrowsByOnFinerCells) {
    // Curvature that doubles once more hides one halving's worth of twice what the last one brought.
    EXPECT_DOUBLE_EQ(unseen_detail(0.01, 0.02), 2);
    EXPECT_DOUBLE_EQ(unseen_detail(0.01, 0.015), 1);
    EXPECT_DOUBLE_EQ(unseen_detail(0.01, 0.01), 0);
    EXPECT_DOUBLE_EQ(unseen_detail(0.02, 0.01), 0);
    // Rounding of a plane's elevations grows with the square of the cells' number, and means nothing.
    EXPECT_DOUBLE_EQ(unseen_detail(1e-9, 4e-9), 0);
    EXPECT_DOUBLE_EQ(unseen_detail(0, 0), 0);
}

TEST(TerrainDetail, IsMeasuredWhereTheFlowWas) {
    // z = x^2 / 100 bends by 0.02 along x and not at all along y.
    Raster terrain(GridSpec{0, 40, 1, 40, 40, ""}), depth(GridSpec{0, 40, 4, 10, 10, ""}, k_no_data);
    for (std::int64_t row = 0; row < 40; ++row)
        for (std::int64_t column = 0; column < 40; ++column)
            terrain.at(row, column) = (column + 0.5) * (column + 0.5) / 100;
    terrain.at(20, 20) = 1000;  // dry
    EXPECT_EQ(ground_curvature(terrain, depth, 0.1), 0);
    depth.at(2, 2) = 1;
    depth.at(7, 7) = 0.05;
    EXPECT_NEAR(ground_curvature(terrain, depth, 0.1), 0.02 / std::sqrt(2.0), 1e-9);
}

TEST(FieldUncertainty, IsTheFieldsOwnErrorForAFirstOrderField) {
    // The same slope at every level plus an error of h everywhere: first order.
    std::vector<Raster> levels;
    for (const double h : {8.0, 4.0, 2.0}) {
        const auto n = static_cast<std::int64_t>(64 / h);
        levels.emplace_back(GridSpec{0, 64, h, n, n, ""}, 5 + h);
    }
    const Raster uncertainty = field_uncertainty(levels);
    EXPECT_EQ(uncertainty.grid.columns, 32);
    // Away from the edge, where the coarse rasters are interpolated between full cells.
    EXPECT_NEAR(uncertainty.at(16, 16), 1.25 * 2, 1e-9);
}

TEST(FieldUncertainty, HasNoValueWhereNothingFlowed) {
    std::vector<Raster> levels;
    for (const double h : {8.0, 4.0, 2.0}) {
        const auto n = static_cast<std::int64_t>(64 / h);
        levels.emplace_back(GridSpec{0, 64, h, n, n, ""}, k_no_data);
        levels.back().at(n / 2, n / 2) = 1;
    }
    const Raster uncertainty = field_uncertainty(levels);
    EXPECT_TRUE(std::isnan(uncertainty.at(0, 0)));
    EXPECT_FALSE(std::isnan(uncertainty.at(16, 16)));
}

}  // namespace
}  // namespace frana
