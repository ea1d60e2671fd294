// SPDX-License-Identifier: Apache-2.0
#include "analysis/convergence.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace frana {
namespace {

// f(h) = 10 + 3 h^p has order p and limit 10 exactly.
std::vector<Refinement> power_law(double order) {
    std::vector<Refinement> levels;
    for (const double h : {8.0, 4.0, 2.0}) levels.push_back({h, 10 + 3 * std::pow(h, order)});
    return levels;
}

TEST(GridConvergence, RecoversOrderAndLimitOfAPowerLaw) {
    for (const double order : {0.6, 1.0, 1.7}) {
        const GridConvergence c = grid_convergence(power_law(order));
        EXPECT_EQ(c.trend, Trend::converging);
        EXPECT_NEAR(c.observed_order, order, 1e-12);
        EXPECT_NEAR(c.extrapolated, 10, 1e-10);
        // The index is the true error times the safety factor.
        EXPECT_NEAR(c.error, 1.25 * 3 * std::pow(2.0, order), 1e-9);
    }
}

TEST(GridConvergence, IsCautiousWhereValuesDoNotConverge) {
    const GridConvergence swing = grid_convergence({{8, 10}, {4, 12}, {2, 11}});
    EXPECT_EQ(swing.trend, Trend::oscillating);
    EXPECT_TRUE(std::isnan(swing.observed_order));
    EXPECT_EQ(swing.extrapolated, 11);
    EXPECT_NEAR(swing.error, 3, 1e-12);  // three times the last difference
    EXPECT_EQ(grid_convergence({{8, 10}, {4, 11}, {2, 13}}).trend, Trend::diverging);
    EXPECT_EQ(grid_convergence({{8, 10}, {4, 11}, {2, 11}}).trend, Trend::settled);
}

TEST(GridConvergence, DoesNotExtrapolateAtAnOrderAboveTheSchemes) {
    const GridConvergence two = grid_convergence(power_law(2)), fast = grid_convergence(power_law(2.8));
    EXPECT_NEAR(two.extrapolated, 10, 1e-10);
    const double finest = power_law(2.8).back().value, last = power_law(2.8)[1].value - finest;
    EXPECT_NEAR(fast.observed_order, 2.8, 1e-12);
    EXPECT_EQ(fast.extrapolated, finest);
    EXPECT_NEAR(fast.error, 3 * last, 1e-9);  // three times the last difference, as where values do not converge
}

TEST(GridConvergence, NeedsThreeLevels) {
    EXPECT_THROW(grid_convergence({{4, 1}, {2, 2}}), Error);
}

// f(h) = 10 + 3 h^p on levels as numerics.accuracy makes them.
std::vector<Refinement> close_levels(double order) {
    std::vector<Refinement> levels;
    for (const double h : {12.0, 8.0, 6.0, 4.0, 3.0, 2.0}) levels.push_back({h, 10 + 3 * std::pow(h, order)});
    return levels;
}

TEST(CloseLevels, RecoverOrderAndLimitOfFirstOrder) {
    const GridConvergence c = grid_convergence(close_levels(1), 0.5);
    EXPECT_EQ(c.trend, Trend::converging);
    EXPECT_NEAR(c.observed_order, 1, 1e-12);
    EXPECT_NEAR(c.extrapolated, 10, 1e-10);
    EXPECT_NEAR(c.error, 1.25 * 3 * 2, 1e-9);  // the true error times the safety factor
}

TEST(CloseLevels, AreCautiousWhereTheOrderIsNotTheMethods) {
    const GridConvergence slow = grid_convergence(close_levels(0.6), 0);
    EXPECT_EQ(slow.trend, Trend::converging);
    EXPECT_NEAR(slow.observed_order, 0.6, 1e-12);
    EXPECT_NEAR(slow.error, 3 * 3 * std::pow(2.0, 0.6), 1e-9);  // three times the true error
    // Order two: f(8) - f(2) = 180 and f(4) - f(2) = 36; first order would leave a third of the one.
    const GridConvergence fast = grid_convergence(close_levels(2), 0);
    EXPECT_EQ(fast.trend, Trend::converging);
    EXPECT_NEAR(fast.observed_order, 2, 1e-12);
    EXPECT_NEAR(fast.error, 3 * 60, 1e-9);
}

TEST(CloseLevels, AreCautiousWhereValuesDoNotConverge) {
    // Two equal values by chance among others that are not.
    const GridConvergence chance = grid_convergence({{8, 4}, {6, 13}, {4, 10}, {3, 10}, {2, 10}}, 0);
    EXPECT_EQ(chance.trend, Trend::oscillating);
    EXPECT_NEAR(chance.error, 3 * (13 - 4) / 3.0, 1e-12);
    const GridConvergence growing = grid_convergence({{8, 10}, {4, 11}, {3, 12}, {2, 13}}, 0);
    EXPECT_EQ(growing.trend, Trend::diverging);
    EXPECT_NEAR(growing.error, 3 * 2, 1e-12);
    // One level between that swings.
    EXPECT_EQ(grid_convergence({{8, 18}, {4, 14}, {3, 15}, {2, 12}}, 0).trend, Trend::oscillating);
    const GridConvergence few = grid_convergence({{4, 14}, {3, 13}, {2, 12}}, 0);
    EXPECT_EQ(few.trend, Trend::unknown);
    EXPECT_NEAR(few.error, 3 * 2, 1e-12);
    const GridConvergence equal = grid_convergence({{8, 7}, {6, 7}, {4, 7}, {3, 7}, {2, 7}}, 9);
    EXPECT_EQ(equal.trend, Trend::settled);
    EXPECT_EQ(equal.error, 0);
}

TEST(CloseLevels, ExpectAsMuchAsTheTerrainStillHides) {
    const GridConvergence rough = grid_convergence(close_levels(1), 2.5);
    EXPECT_EQ(rough.trend, Trend::terrain);
    EXPECT_NEAR(rough.error, 2.5 * 3 * 6, 1e-9);  // 3 (f(4) - f(2)) for each halving's worth of detail
    EXPECT_EQ(grid_convergence(close_levels(1), 1).trend, Trend::converging);
}

TEST(CloseLevels, NeedThreeOfWhichOneIsTwiceTheFinest) {
    EXPECT_TRUE(enough_levels({8, 4, 2}));
    EXPECT_TRUE(enough_levels({4, 3, 2}));
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
