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

TEST(GridConvergence, NeedsThreeLevels) {
    EXPECT_THROW(grid_convergence({{4, 1}, {2, 2}}), Error);
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
