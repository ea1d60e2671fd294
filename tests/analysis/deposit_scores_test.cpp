// SPDX-License-Identifier: Apache-2.0
#include "analysis/scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "row_of.h"

namespace frana {
namespace {

TEST(DepositScores, ByHand) {
    // Counted: cells 0 (2 against 1), 1 (1 against 3), 2 (none against 2). Not: 3 (erosion, nothing
    // simulated), 4 (not surveyed), 5 (both under the threshold).
    const Raster simulated = row_of({2, 1, k_no_data, 0, 5, 0.1});
    const Raster observed = row_of({1, 3, 2, -4, k_no_data, 0.2});
    const DepositScores s = compare_deposit(simulated, observed, 0.5);
    EXPECT_EQ(s.area_m2, 300);
    EXPECT_EQ(s.observed_volume_m3, 600);
    EXPECT_EQ(s.simulated_volume_m3, 300);
    EXPECT_EQ(s.bias_m, -1);                               // (1 - 2 - 2) / 3
    EXPECT_NEAR(s.mean_absolute_error_m, 5.0 / 3, 1e-15);  // (1 + 2 + 2) / 3
    EXPECT_NEAR(s.rmse_m, std::sqrt(3.0), 1e-15);          // (1 + 4 + 4) / 3
    // Means 1 and 2: covariance (1)(-1) + (0)(1) + (-1)(0) = -1, variances 2 and 2.
    EXPECT_NEAR(s.correlation, -0.5, 1e-15);
}

TEST(DepositScores, DepthsThatDoNotVaryHaveNoCorrelation) {
    EXPECT_TRUE(std::isnan(compare_deposit(row_of({1, 1}), row_of({1, 2}), 0.5).correlation));
    EXPECT_THROW(compare_deposit(row_of({0.1}), row_of({-1}), 0.5), Error);
}

}  // namespace
}  // namespace frana
