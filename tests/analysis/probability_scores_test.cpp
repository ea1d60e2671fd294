// SPDX-License-Identifier: Apache-2.0
#include "analysis/scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "row_of.h"

namespace frana {
namespace {

constexpr double k_sum_rounding = 1e-14;  // sums of a few numbers near 1

// Three observed cells, so 15 that were not: one with a probability, 14 rightly at 0; 18 together.
TEST(ProbabilityScores, ByHand) {
    const ProbabilityScores scores = score_probability(row_of({1, 0.8, 0.4, 0, k_no_data}), row_of({1, 1, 0, 1, 0}));
    EXPECT_EQ(scores.observed_area_m2, 300);
    EXPECT_EQ(scores.compared_area_m2, 1800);
    EXPECT_NEAR(scores.brier, (0.04 + 0.16 + 1) / 18, k_sum_rounding);
    EXPECT_NEAR(scores.uncertainty, 1.0 / 6 * 5 / 6, k_sum_rounding);
    EXPECT_NEAR(scores.reliability, (15 * std::pow(1.0 / 15, 2) + 0.16 + 0.04) / 18, k_sum_rounding);
    EXPECT_NEAR(scores.resolution, (15 * 0.01 + 1.0 / 36 + 2 * 25.0 / 36) / 18, k_sum_rounding);
    EXPECT_NEAR(scores.within_classes, 0, k_sum_rounding);  // one probability in each class
    EXPECT_NEAR(scores.brier_skill, 1 - 1.2 / 18 / (5.0 / 36), k_sum_rounding);
    ASSERT_EQ(scores.classes.size(), 10U);
    EXPECT_EQ(scores.classes[0].area_m2, 1500);
    EXPECT_NEAR(scores.classes[0].observed_fraction, 1.0 / 15, k_sum_rounding);
    EXPECT_EQ(scores.classes[4].observed_fraction, 0);
    EXPECT_EQ(scores.classes[8].mean_probability, 0.8);
    EXPECT_EQ(scores.classes[9].mean_probability, 1);
    EXPECT_EQ(scores.classes[5].area_m2, 0);
    // Corners (0, 1/3), (0, 2/3), (1/15, 2/3), (1, 1).
    ASSERT_EQ(scores.roc.size(), 3U);
    EXPECT_EQ(scores.roc[1].value, 0.8);
    EXPECT_NEAR(scores.roc[2].false_positive_rate, 1.0 / 15, k_sum_rounding);
    EXPECT_NEAR(scores.auroc, 2.0 / 45 + 14.0 / 15 * 5 / 6, k_sum_rounding);
}

// Two cells of one class: differences of -0.03 and 0.03 from its mean, -0.5 and 0.5 from its observed fraction; 6
// cells.
TEST(ProbabilityScores, WhatTheClassesHideIsSaid) {
    const ProbabilityScores scores = score_probability(row_of({0.42, 0.48}), row_of({0, 1}));
    EXPECT_NEAR(scores.within_classes, (2 * 0.0009 - 2 * 2 * 0.03 * 0.5) / 6, k_sum_rounding);
    EXPECT_NEAR(scores.brier, (0.42 * 0.42 + 0.52 * 0.52) / 6, k_sum_rounding);
    EXPECT_NEAR(scores.reliability - scores.resolution + scores.uncertainty + scores.within_classes, scores.brier,
                k_sum_rounding);
}

TEST(ProbabilityScores, CertaintyThatIsRightIsPerfect) {
    const ProbabilityScores scores = score_probability(row_of({1, 1, 0}), row_of({1, 1, 0}));
    EXPECT_EQ(scores.brier, 0);
    EXPECT_EQ(scores.brier_skill, 1);
    EXPECT_EQ(scores.auroc, 1);
}

TEST(ProbabilityScores, TheMapAroundDoesNotCount) {
    std::vector<double> p{0.7, 0.2, 0.5}, o{1, 0, 1};
    const ProbabilityScores small = score_probability(row_of(p), row_of(o));
    p.resize(1000);
    o.resize(1000);
    const ProbabilityScores large = score_probability(row_of(p), row_of(o));
    EXPECT_EQ(small.brier, large.brier);
    EXPECT_EQ(small.auroc, large.auroc);
    EXPECT_EQ(small.compared_area_m2, large.compared_area_m2);
}

TEST(ProbabilityScores, NothingObservedIsRefused) {
    EXPECT_THROW((void)score_probability(row_of({0.5}), row_of({0})), Error);
}

}  // namespace
}  // namespace frana
