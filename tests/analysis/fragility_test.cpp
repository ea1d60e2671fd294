// SPDX-License-Identifier: Apache-2.0
#include "analysis/fragility.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frana {
namespace {

TEST(Fragility, LogNormalHasItsMedianAndDeviation) {
    const DamageState state{.name = "collapse", .loss = 1, .median = 2, .beta = 0.5};
    EXPECT_EQ(state.probability(0), 0);
    EXPECT_NEAR(state.probability(2), 0.5, 1e-15);
    // One deviation of the logarithm above the median: Phi(1) of tables.
    EXPECT_NEAR(state.probability(2 * std::exp(0.5)), 0.8413447460685429, 1e-14);
}

TEST(Fragility, WithoutADeviationItIsAStep) {
    const DamageState state{.name = "collapse", .loss = 1, .median = 0.5};
    EXPECT_EQ(state.probability(0.5), 0);
    EXPECT_EQ(state.probability(std::nextafter(0.5, 1)), 1);
}

TEST(Fragility, LossIsTheSumOverTheStates) {
    const FragilityClass kind{.states = {{"light", 0.1, 1, 0.5}, {"heavy", 0.6, 2, 0.5}}};
    EXPECT_EQ(kind.loss(0), 0);
    const double light = kind.states[0].probability(1.5), heavy = kind.states[1].probability(1.5);
    EXPECT_NEAR(kind.loss(1.5), (light - heavy) * 0.1 + heavy * 0.6, 1e-15);
}

TEST(Fragility, AWorseStateIsNeverLikelier) {
    // The curves cross far below the medians, where the wider one is higher.
    const FragilityClass kind{.states = {{.name = "light", .loss = 0.1, .median = 1, .beta = 0.2},
                                         {.name = "heavy", .loss = 1, .median = 1.5, .beta = 0.9}}};
    const double x = 0.3, light = kind.states[0].probability(x);
    ASSERT_GT(kind.states[1].probability(x), light);
    EXPECT_NEAR(kind.loss(x), light, 1e-15);
}

}  // namespace
}  // namespace frana
