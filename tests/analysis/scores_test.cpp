// SPDX-License-Identifier: Apache-2.0
#include "analysis/scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "row_of.h"

namespace frana {
namespace {

// Ratios of small whole numbers: only the last bits of a double may differ.
constexpr double k_rounding = 1e-15;

TEST(Scores, CountsByHand) {
    // Two hits, one false alarm, two misses, three cells never touched; the threshold itself does not count.
    const Raster depth = row_of({3.0, 2.0, 1.5, 0.5, k_no_data, k_no_data, 0.1, 0.0});
    const Raster observed = row_of({1, 1, 0, 1, 1, 0, 0, k_no_data});
    const ComparisonStatistics statistics = compare(depth, observed, 0.5);
    EXPECT_EQ(statistics.hit_m2, 200);
    EXPECT_EQ(statistics.false_alarm_m2, 100);
    EXPECT_EQ(statistics.miss_m2, 200);
    EXPECT_EQ(statistics.observed_area_m2, 400);
    EXPECT_EQ(statistics.simulated_area_m2, 300);
    EXPECT_EQ(statistics.threshold_m, 0.5);
    EXPECT_NEAR(statistics.area_difference_percent, 25, 100 * k_rounding);
    EXPECT_NEAR(statistics.jaccard, 2.0 / 5, k_rounding);
    EXPECT_NEAR(statistics.csi, 2.0 / 5, k_rounding);
    EXPECT_NEAR(statistics.dice, 4.0 / 7, k_rounding);
    EXPECT_NEAR(statistics.true_positive_rate, 0.5, k_rounding);
    EXPECT_NEAR(statistics.false_positive_rate, 1.0 / 20, k_rounding);
    EXPECT_NEAR(statistics.d2pc, std::sqrt(0.25 + 0.0025), k_rounding);
}

TEST(Scores, RocCurveByHand) {
    // Depths 3 (observed), 2 (not), 1 (observed); one observed cell dry: positives 3, negatives 15.
    const Raster depth = row_of({3, 2, 1, k_no_data});
    const Raster observed = row_of({1, 0, 1, 1});
    // Corners (0,0) (0,1/3) (1/15,1/3) (1/15,2/3) (1,1): trapezoids 1/15 * 1/3 + 14/15 * 5/6.
    EXPECT_NEAR(compare(depth, observed, 0).auroc, 1.0 / 45 + 14.0 / 18, k_rounding);
}

TEST(Scores, EqualDepthsPassTheThresholdTogether) {
    const Raster forward = row_of({1, 1}), observed = row_of({1, 0}), swapped = row_of({0, 1});
    EXPECT_EQ(compare(forward, observed, 0).auroc, compare(forward, swapped, 0).auroc);
}

TEST(Scores, PerfectAgreement) {
    const Raster depth = row_of({1, 2, k_no_data}), observed = row_of({1, 1, 0});
    const ComparisonStatistics statistics = compare(depth, observed, 0.1);
    EXPECT_EQ(statistics.jaccard, 1);
    EXPECT_EQ(statistics.d2pc, 0);
    EXPECT_EQ(statistics.auroc, 1);
    EXPECT_EQ(statistics.area_difference_percent, 0);
}

TEST(Scores, DoNotDependOnTheSizeOfTheMap) {
    const ComparisonStatistics tight = compare(row_of({1, 1, 1}), row_of({1, 1, 0}), 0.1);
    const ComparisonStatistics wide =
        compare(row_of({1, 1, 1, 0, 0, 0, 0, 0, k_no_data}), row_of({1, 1, 0, 0, 0, 0, 0, 0, 0}), 0.1);
    EXPECT_EQ(tight.d2pc, wide.d2pc);
    EXPECT_EQ(tight.auroc, wide.auroc);
    EXPECT_EQ(tight.false_positive_rate, wide.false_positive_rate);
}

TEST(Scores, NothingSimulatedIsAMissEverywhere) {
    const ComparisonStatistics statistics = compare(row_of({k_no_data, k_no_data}), row_of({1, 0}), 0.1);
    EXPECT_EQ(statistics.hit_m2, 0);
    EXPECT_EQ(statistics.miss_m2, 100);
    EXPECT_EQ(statistics.area_difference_percent, 100);
    EXPECT_EQ(statistics.auroc, 0.5);  // no information
}

TEST(Scores, NothingObservedIsRefused) {
    EXPECT_THROW(compare(row_of({1, 1}), row_of({0, k_no_data}), 0.1), Error);
}

TEST(Scores, DifferentGridsAreRefused) {
    EXPECT_THROW(compare(row_of({1, 1}), row_of({1, 1}, 5), 0.1), Error);
    EXPECT_THROW(agreement(row_of({1, 1}), row_of({1}), 0.1), Error);
}

TEST(Scores, AgreementClasses) {
    const Raster classes = agreement(row_of({1, 1, k_no_data, k_no_data}), row_of({1, 0, 1, 0}), 0.1);
    EXPECT_EQ(classes.values[0], 1);
    EXPECT_EQ(classes.values[1], 2);
    EXPECT_EQ(classes.values[2], 3);
    EXPECT_TRUE(std::isnan(classes.values[3]));
}

TEST(Scores, TheCurveOverTheThresholdByHand) {
    const Raster depth = row_of({3, 2, 0.012, k_no_data});
    const Raster observed = row_of({1, 0, 1, 1});
    const std::vector<ComparisonStatistics> curve = score_curve(depth, observed);
    // 0; 0.01, 0.015 ... 0.07; 0.1 ... 0.7; 1, 1.5, 2 (3 is not below the greatest depth).
    ASSERT_EQ(curve.size(), 1U + 6 + 6 + 3);
    EXPECT_EQ(curve[0].threshold_m, 0);
    EXPECT_NEAR(curve[0].jaccard, 2.0 / 4, k_rounding);
    EXPECT_NEAR(curve[1].jaccard, 2.0 / 4, k_rounding);  // 0.012 is above 0.01 ...
    EXPECT_NEAR(curve[2].jaccard, 1.0 / 4, k_rounding);  // ... but not above 0.015
    EXPECT_NEAR(curve.back().threshold_m, 2, 1e-12);
    EXPECT_NEAR(curve.back().jaccard, 1.0 / 3, k_rounding);
    for (const ComparisonStatistics& statistics : curve) EXPECT_EQ(statistics.auroc, compare(depth, observed, 1).auroc);
}

TEST(DepositScores, ByHand) {
    // Counted: cells 0 (2 against 1), 1 (1 against 3), 2 (none against 2). Not: 3 (erosion, nothing
    // simulated), 4 (not surveyed), 5 (both under the threshold).
    const Raster simulated = row_of({2, 1, k_no_data, 0, 5, 0.1});
    const Raster observed = row_of({1, 3, 2, -4, k_no_data, 0.2});
    const DepositScores s = compare_deposit(simulated, observed, 0.5);
    EXPECT_EQ(s.area_m2, 300);
    EXPECT_EQ(s.observed_volume_m3, 600);
    EXPECT_EQ(s.simulated_volume_m3, 300);
    EXPECT_EQ(s.bias_m, -1);                        // (1 - 2 - 2) / 3
    EXPECT_NEAR(s.observed_raised_m3, 620, 1e-12);  // 1 + 3 + 2 + 0.2
    EXPECT_EQ(s.observed_lowered_m3, 400);
    EXPECT_NEAR(s.simulated_raised_m3, 310, 1e-12);  // 2 + 1 + 0.1
    EXPECT_EQ(s.simulated_raised_beyond_m3, 500);
    EXPECT_NEAR(s.change_rmse_m, std::sqrt((1 + 4 + 4 + 16 + 0.01) / 5), 1e-12);
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
